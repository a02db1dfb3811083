#include "walkcycle/render/AnimatedModel.h"

#include <cstddef>
#include <utility>

#include "render/CurrentContext.h"
#include "render/ModelResource.h"

namespace walkcycle {
namespace {

std::shared_ptr<ModelResource> buffersOf(const Model& model) {
    requireContext();
    return std::make_shared<ModelResource>(model);
}

}  // namespace

AnimatedModel::AnimatedModel(Model model) : AnimatedModel(std::make_shared<const Model>(std::move(model))) {}

AnimatedModel::AnimatedModel(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      resource_(buffersOf(*model_)),
      animator_(model_->skeleton, model_->restParameters()),
      scene_(*model_) {}

void AnimatedModel::doAnimation(const Animation& animation) {
    animator_.doAnimation(animation);
    scene_.apply(*model_, animator_.parameters());
    boundsKnown_ = false;
}

void AnimatedModel::update(double seconds) {
    animator_.update(seconds);
    scene_.apply(*model_, animator_.parameters());
}

void AnimatedModel::setTime(double seconds) {
    animator_.setTime(seconds);
    scene_.apply(*model_, animator_.parameters());
}

void AnimatedModel::step(double seconds) {
    animator_.step(seconds);
    scene_.apply(*model_, animator_.parameters());
}

void AnimatedModel::sampleAt(double documentSeconds) {
    animator_.sampleAt(documentSeconds);
    scene_.apply(*model_, animator_.parameters());
}

// A hidden node hides its descendants.
bool AnimatedModel::visible(int node) const {
    for (int n = node; n != kNoParent; n = model_->skeleton.joints[static_cast<std::size_t>(n)].parent) {
        if (!scene_.nodeVisible[static_cast<std::size_t>(n)]) return false;
    }
    return true;
}

const Bounds& AnimatedModel::bounds() const {
    if (!boundsKnown_) bounds_ = animatedBounds(*model_, animator_.animation());
    boundsKnown_ = true;
    return bounds_;
}

}  // namespace walkcycle
