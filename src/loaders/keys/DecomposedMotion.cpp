#include "loaders/keys/DecomposedMotion.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace walkcycle {

DecomposedMotion::DecomposedMotion(const JointMotion& motion, const Tolerance& tolerance)
    : motion_(motion), tolerance_(tolerance), isWholeMatrix_(motion.isStraight()) {
    if (motion.hasPlainStack()) stack_.emplace(motion);
}

ExactTransform DecomposedMotion::at(double seconds, Side side) {
    const MatrixParts* const key = isWholeMatrix_ && side == Side::Right ? partsOfKey(seconds) : nullptr;
    MatrixParts other;
    if (!key && (!stack_ || !stack_->at(seconds, side, other)))
        other = partsOf(motion_.localTransform(seconds, side), lastRotation_);
    const MatrixParts& parts = key ? *key : other;
    lastRotation_ = glm::dot(parts.rotation, lastRotation_) < 0.0 ? -parts.rotation : parts.rotation;
    noteLoss(parts);
    return {parts.position, lastRotation_, parts.scale()};
}

void DecomposedMotion::noteLoss(const MatrixParts& parts) {
    const bool isMirrored = parts.stretch[0][0] < 0.0;
    if (!isMirrored_) isMirrored_ = isMirrored;
    lost_ = parts.hasRotation && isMirrored == *isMirrored_ ? std::max(lost_, shear(parts, tolerance_))
                                                            : std::numeric_limits<double>::infinity();
}

bool DecomposedMotion::holds(const std::vector<double>& knots) {
    for (std::size_t i = 1; i < knots.size() && holds(); ++i) {
        at(knots[i - 1], Side::Right);
        at(0.5 * (knots[i - 1] + knots[i]), Side::Right);
    }
    return holds();
}

// The parts of the key at this time: the curve of a whole matrix has them already. Null between keys, at a
// jump, and if the key has no rotation.
const MatrixParts* DecomposedMotion::partsOfKey(double seconds) {
    const Curve& curve = *motion_.bindings[0].curve;
    const std::vector<double>& times = curve.times;
    ++key_;
    if (key_ >= times.size() || times[key_] != seconds || times[key_ - 1] == seconds)
        key_ =
            static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), seconds) - times.begin());
    const bool isKey = key_ < times.size() && times[key_] == seconds;
    if (!isKey || (key_ + 1 < times.size() && times[key_ + 1] == seconds) || curve.parts.empty())
        return nullptr;
    return curve.parts[key_].hasRotation ? &curve.parts[key_] : nullptr;
}

}  // namespace walkcycle
