#pragma once

#include <cstddef>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/animation/Joint.h>
#include <walkcycle/animation/JointTransform.h>

namespace walkcycle {

// The transform of every joint of a skeleton, relative to its parent, at one time. Kept as matrices, since a
// JointTransform cannot hold shear or mirroring.
class WALKCYCLE_API Pose {
public:
    Pose() = default;
    explicit Pose(const Skeleton& skeleton);  // the rest pose: each joint's localBindTransform

    std::size_t size() const { return matrices_.size(); }  // the number of joints

    // `joint` is an index into Skeleton::joints. The matrix leads from joint space to the parent's space.
    void set(std::size_t joint, const JointTransform& transform) { matrices_[joint] = transform.toMatrix(); }
    void set(std::size_t joint, const glm::mat4& matrix) { matrices_[joint] = matrix; }
    const glm::mat4& localTransform(std::size_t joint) const { return matrices_[joint]; }

private:
    std::vector<glm::mat4> matrices_;
};

}  // namespace walkcycle
