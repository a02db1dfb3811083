#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "animation/Animator.h"
#include "model/Bounds.h"
#include "model/Model.h"
#include "model/SceneState.h"

namespace walkcycle {

class ModelResource;

// A character on the screen: a model's buffers on the GPU, which its copies share, and the Animator that
// moves this one. Needs a current OpenGL context. Starts in the rest pose.
//
//     AnimatedModel model(loadCollada("res/walker.dae"));
//     model.doAnimation(model.animations().front());
//     model.update(1.0 / 60.0);  // or setTime(seconds into the clip), or sampleAt(seconds of the document)
class AnimatedModel {
public:
    explicit AnimatedModel(Model model);
    explicit AnimatedModel(std::shared_ptr<const Model> model);

    const std::vector<Animation>& animations() const { return model_->animations; }
    void doAnimation(
        const Animation& animation);  // one of this model, or made for its skeleton and outliving this
    void doAnimation(std::string_view clip) { doAnimation(model_->animation(clip)); }  // throws NoSuchClip
    void update(double seconds);
    void setTime(double seconds);
    void sampleAt(double documentSeconds);

    const Model& model() const { return *model_; }
    const Animator& animator() const { return animator_; }
    const SceneState& scene() const { return scene_; }  // materials, cameras, lights as they are now
    bool visible(int node) const;                       // neither the node nor one above it is hidden

    // What a camera must show so that nothing leaves the picture during the clip (without one: the rest
    // pose). Worked out when first asked for after doAnimation.
    const Bounds& bounds() const;

    const std::shared_ptr<ModelResource>& resource() const { return resource_; }

private:
    std::shared_ptr<const Model> model_;
    std::shared_ptr<ModelResource> resource_;
    Animator animator_;
    SceneState scene_;
    mutable Bounds bounds_;
    mutable bool boundsKnown_ = false;
};

}  // namespace walkcycle
