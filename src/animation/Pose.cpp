#include "walkcycle/animation/Pose.h"

namespace walkcycle {

Pose::Pose(const Skeleton& skeleton) {
    matrices_.reserve(skeleton.joints.size());
    for (const Joint& joint : skeleton.joints) matrices_.push_back(joint.localBindTransform);
}

}  // namespace walkcycle
