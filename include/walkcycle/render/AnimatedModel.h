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

// A character on the screen: a model, its buffers and textures on the GPU, and an Animator. Copies share the model
// and the buffers; each copy has an Animator of its own. Starts in the rest pose. Each constructor needs a current
// OpenGL context, and the character can be drawn in that context only.
//
//     AnimatedModel model(loadCollada("res/walker.dae"));
//     model.doAnimation(model.animations().front());
//     model.update(1.0 / 60.0);  // or setTime(seconds into the clip), or sampleAt(seconds of the document)
class WALKCYCLE_API AnimatedModel {
public:
    explicit AnimatedModel(Model model);
    explicit AnimatedModel(std::shared_ptr<const Model> model);

    // The clips of the model: first the document's whole timeline, then the clips that the file names.
    const std::vector<Animation>& animations() const { return model_->animations; }

    // Starts a clip. It is one of animations(), or a clip for the same skeleton that outlives this object.
    void doAnimation(const Animation& animation);
    void doAnimation(const Animation&& temporary) = delete;
    // Starts the clip of that name. Throws NoSuchClip.
    void doAnimation(std::string_view clip) { doAnimation(model_->animation(clip)); }

    // The functions of the same names of Animator, which describes them. The first four also update scene().
    void update(double seconds);
    void setTime(double seconds);
    void step(double seconds);
    void sampleAt(double documentSeconds);
    void setSpeed(double speed) { animator_.setSpeed(speed); }
    void setLoopMode(LoopMode mode) { animator_.setLoopMode(mode); }

    const Model& model() const { return *model_; }
    const Animator& animator() const { return animator_; }  // the pose, the time and the speed at this moment

    // The materials, cameras and lights with the values that they have at this moment.
    const SceneState& scene() const { return scene_; }

    // Whether a node (an index into Skeleton::joints) is shown at this moment: neither it nor an ancestor is hidden.
    bool visible(int node) const;

    // A box in model space that encloses the model during the whole clip; without a clip, in the rest pose.
    // Computed at the first call after doAnimation().
    const Bounds& bounds() const;

    // The buffers and textures on the GPU, for the renderers of this library.
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
