#include "SeriesAnimator.h"

#include <cstddef>
#include <utility>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtx/matrix_decompose.hpp>

#include "walkcycle/animation/Animator.h"

namespace walkcycle::bench {
namespace {

std::string nameOf(int joint) {
    return "joint_" + std::to_string(joint);
}

JointTransform decomposed(const glm::mat4& matrix) {
    JointTransform transform;
    glm::vec3 skew;
    glm::vec4 perspective;
    glm::decompose(matrix, transform.scale, transform.rotation, transform.position, skew, perspective);
    return transform;
}

}  // namespace

SeriesAnimator::SeriesAnimator(const Model& model, const Animation& animation, int keyFrames) {
    const Skin& skin = model.skins.front();
    palette_.resize(skin.joints.size());
    const int joints = static_cast<int>(model.skeleton.joints.size());
    for (int i = 0; i < joints; ++i)
        if (model.skeleton.joints[static_cast<std::size_t>(i)].parent == kNoParent)
            roots_.push_back(treeFrom(model, skin, i));
    Animator animator(model.skeleton);
    animator.doAnimation(animation);
    for (int k = 0; k < keyFrames; ++k) {
        SeriesKeyFrame frame;
        frame.timeStamp = animation.lengthInSeconds() * k / (keyFrames - 1);
        animator.sampleAt(animation.startSeconds + frame.timeStamp);
        for (int i = 0; i < joints; ++i)
            frame.pose[nameOf(i)] = decomposed(animator.pose().localTransform(static_cast<std::size_t>(i)));
        keyFrames_.push_back(std::move(frame));
    }
}

SeriesAnimator::TreeJoint SeriesAnimator::treeFrom(const Model& model, const Skin& skin, int joint) const {
    TreeJoint made;
    made.name = nameOf(joint);
    for (std::size_t i = 0; i + 1 < skin.joints.size(); ++i) {
        if (skin.joints[i] != joint) continue;
        made.index = static_cast<int>(i);
        made.inverseBind = skin.bindMatrices[i];
    }
    const auto& joints = model.skeleton.joints;
    for (std::size_t i = 0; i < joints.size(); ++i)
        if (joints[i].parent == joint) made.children.push_back(treeFrom(model, skin, static_cast<int>(i)));
    return made;
}

std::map<std::string, glm::mat4> SeriesAnimator::currentPose() const {
    const SeriesKeyFrame* previous = &keyFrames_.front();
    const SeriesKeyFrame* next = previous;
    for (std::size_t i = 1; i < keyFrames_.size(); ++i) {
        next = &keyFrames_[i];
        if (next->timeStamp > time_) break;
        previous = next;
    }
    const double length = next->timeStamp - previous->timeStamp;
    const float progression =
        length > 0.0 ? static_cast<float>((time_ - previous->timeStamp) / length) : 0.0f;
    std::map<std::string, glm::mat4> pose;
    for (const auto& [name, transform] : previous->pose)
        pose[name] = JointTransform::interpolate(transform, next->pose.at(name), progression).toMatrix();
    return pose;
}

void SeriesAnimator::applyPoseToJoints(const std::map<std::string, glm::mat4>& pose, const TreeJoint& joint,
                                       const glm::mat4& parentTransform) {
    const glm::mat4 transform = parentTransform * pose.at(joint.name);
    for (const TreeJoint& child : joint.children) applyPoseToJoints(pose, child, transform);
    if (joint.index >= 0) palette_[static_cast<std::size_t>(joint.index)] = transform * joint.inverseBind;
}

const std::vector<glm::mat4>& SeriesAnimator::update() {
    const std::map<std::string, glm::mat4> pose = currentPose();
    for (const TreeJoint& root : roots_) applyPoseToJoints(pose, root, glm::mat4(1.0f));
    return palette_;
}

}  // namespace walkcycle::bench
