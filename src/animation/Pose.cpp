#include "animation/Pose.h"

namespace walkcycle {

Pose::Pose(const Skeleton& skeleton) {
    matrices_.reserve(skeleton.joints.size());
    for (const Joint& joint : skeleton.joints) matrices_.push_back(joint.localBindTransform);
}

void modelTransforms(const Skeleton& skeleton, const Pose& pose, std::vector<glm::mat4>& transforms) {
    transforms.resize(skeleton.joints.size());
    for (std::size_t i = 0; i < transforms.size(); ++i) {
        const int parent = skeleton.joints[i].parent;
        // The document's axes and unit are converted here, above the roots, and nowhere else.
        const glm::mat4& above =
            parent == kNoParent ? skeleton.rootTransform : transforms[static_cast<std::size_t>(parent)];
        transforms[i] = above * pose.localTransform(i);
    }
}

}  // namespace walkcycle
