#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/curves/ChannelTarget.h"
#include "loaders/curves/Motion.h"
#include "loaders/curves/ParameterFinder.h"
#include "loaders/curves/SamplerReader.h"
#include "loaders/document/XmlNode.h"
#include "loaders/scene/AnimationTargets.h"
#include "loaders/scene/SceneGraph.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Builds the Motion of a document: reads the sampler of each channel, finds the numbers that the channel
// targets, and binds the curve to them.
class MotionBuilder {
public:
    MotionBuilder(const SceneGraph& scene, const AnimationTargets& targets, const LoadContext& context,
                  Model& model);

    void add(XmlNode channel);  // in document order
    int channelCount() const { return static_cast<int>(channels_.size()); }

    // Returns the motion, or null if nothing moves. `together(a, b)`: whether channels a and b play at the
    // same time (see playTogether). Two such channels that move the same numbers are reported.
    std::shared_ptr<Motion> finish(const std::function<bool(int, int)>& together);

private:
    struct JointBinding {
        int joint;
        int curve;
        CurveBinding binding;
    };
    struct ParameterBinding {
        int parameter;
        int curve;
        ParameterMotion::Binding binding;
    };
    void bindNode(XmlNode channel, const ChannelTarget& target, int curve);
    void bindInOwnSpace(XmlNode channel, const TransformElement& element, int joint, int curve,
                        const CurveBinding& binding);
    void reportFirstTaken(XmlNode channel, std::size_t given, std::size_t taken);
    void bindParameters(XmlNode channel, const ChannelTarget& target, int curve);
    void addJoints(Motion& motion, const std::function<bool(int, int)>& together);
    void addParameters(Motion& motion);
    void reportRivals(const JointMotion& motion, const std::function<bool(int, int)>& together);

    const SceneGraph& scene_;
    const LoadContext& context_;
    Model& model_;
    SamplerReader samplers_;
    ParameterFinder parameters_;
    SidFinder sids_;
    std::vector<XmlNode> channels_;
    std::vector<JointBinding> jointBindings_;
    std::vector<ParameterBinding> parameterBindings_;
};

}  // namespace walkcycle
