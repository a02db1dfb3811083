#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "loaders/curves/Motion.h"
#include "loaders/curves/StackParts.h"
#include "loaders/keys/KeyForms.h"

namespace walkcycle {

// The exact motion of one joint as position, rotation and scale, which cannot hold every matrix: lost() tells what the
// matrices that were asked for had beyond that.
class DecomposedMotion {
public:
    DecomposedMotion(const JointMotion& motion, const Tolerance& tolerance);

    // Neighbouring times should be asked for one after the other: the rotation stays on the last one's side of q and -q.
    ExactTransform at(double seconds, Side side);

    // The largest distance in model space by which shear moved a point. Infinite if the joint is mirrored on the way, or
    // flattened until it has no rotation.
    double lost() const { return lost_; }
    bool holds() const { return lost_ <= 2.0 * tolerance_.budget; }
    // The same after a look at the knots and between them, which costs less than fitting keys in vain.
    bool holds(const std::vector<double>& knots);

private:
    const MatrixParts* partsOfKey(double seconds);
    void noteLoss(const MatrixParts& parts);

    const JointMotion& motion_;
    Tolerance tolerance_;
    bool isWholeMatrix_;
    std::optional<StackParts> stack_;
    std::size_t key_ = 0;  // the one that was asked for last
    glm::dquat lastRotation_{1.0, 0.0, 0.0, 0.0};
    std::optional<bool> isMirrored_;  // at the first time
    double lost_ = 0.0;
};

}  // namespace walkcycle
