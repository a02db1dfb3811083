#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "loaders/curves/Motion.h"
#include "loaders/curves/StackParts.h"
#include "loaders/keys/KeyForms.h"

namespace walkcycle {

// The exact motion of one joint as position, rotation and scale. These cannot represent every matrix; lost()
// gives the error over all times that at() was called for.
class DecomposedMotion {
public:
    DecomposedMotion(const JointMotion& motion, const Tolerance& tolerance);

    // Call it with neighbouring times one after the other: of q and -q, the rotation is the one nearer to the
    // last result.
    ExactTransform at(double seconds, Side side);

    // The largest distance in model space by which the lost shear moves a point. Infinite if the joint is
    // mirrored at some times only, or scaled so flat that it has no rotation.
    double lost() const { return lost_; }
    // Whether lost() is small enough for position, rotation and scale to be fitted.
    bool holds() const { return lost_ <= 2.0 * tolerance_.budget; }
    // The same, after calls of at() for the knots and the times halfway between. This costs less than fitting
    // keys in vain.
    bool holds(const std::vector<double>& knots);

private:
    const MatrixParts* partsOfKey(double seconds);
    void noteLoss(const MatrixParts& parts);

    const JointMotion& motion_;
    Tolerance tolerance_;
    bool isWholeMatrix_;
    std::optional<StackParts> stack_;
    std::size_t key_ = 0;  // of the last call of partsOfKey()
    glm::dquat lastRotation_{1.0, 0.0, 0.0, 0.0};
    std::optional<bool> isMirrored_;  // at the time of the first call
    double lost_ = 0.0;
};

}  // namespace walkcycle
