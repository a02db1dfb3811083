#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/animation/Animator.h>
#include <walkcycle/model/Bounds.h>
#include <walkcycle/model/Model.h>
#include <walkcycle/model/SceneState.h>

namespace walkcycle {

class ModelResource;

// A character on the screen: the model's buffers on the GPU, which all copies share, and the Animator of this
// one. Needs a current OpenGL context. Starts in the rest pose.
//
//     AnimatedModel model(loadCollada("res/walker.dae"));
//     model.doAnimation(model.animations().front());
//     model.update(1.0 / 60.0);  // or setTime(seconds into the clip), or sampleAt(seconds of the document)
class WALKCYCLE_API AnimatedModel {
public:
    explicit AnimatedModel(Model model);
    explicit AnimatedModel(std::shared_ptr<const Model> model);

    const std::vector<Animation>& animations() const { return model_->animations; }

    // These are the Animator's. The clip is one of this model, or made for its skeleton and outliving this.
    void doAnimation(const Animation& animation);
    void doAnimation(const Animation&& temporary) = delete;
    void doAnimation(std::string_view clip) { doAnimation(model_->animation(clip)); }  // throws NoSuchClip
    void update(double seconds);
    void setTime(double seconds);
    void step(double seconds);
    void sampleAt(double documentSeconds);
    void setSpeed(double speed) { animator_.setSpeed(speed); }
    void setLoopMode(LoopMode mode) { animator_.setLoopMode(mode); }

    const Model& model() const { return *model_; }
    const Animator& animator() const { return animator_; }
    const SceneState& scene() const { return scene_; }  // materials, cameras, lights as they are now
    bool visible(int node) const;                       // neither the node nor an ancestor is hidden

    // The bounds that the model stays within during the whole clip (without a clip: of the rest pose).
    // Computed at the first call after doAnimation().
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
