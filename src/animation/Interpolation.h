#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

namespace walkcycle {

// Interpolation between two values: in float when a clip is played, in double when a file's curves become key frames.
// (ClipTimeline.cpp has SIMD forms of both, for four joints at once; tests compare them with these.)

// Slerp: rotates from a to b at constant speed, the short way round. Both must be of unit length. The constructor
// computes all that does not depend on the progression.
template <typename Number>
class Slerp {
public:
    Slerp() = default;
    Slerp(const glm::qua<Number>& a, const glm::qua<Number>& b) : a_(a), b_(b) {
        // q and -q are the same rotation; flip one so that the blend takes the short way round.
        Number cosine = glm::dot(a, b);
        if (cosine < Number(0)) b_ = -b_;
        cosine = std::min(std::abs(cosine), Number(1));
        cosineLessOne_ = cosine - Number(1);
        if (isNarrow()) return;
        angle_ = std::acos(cosine);
        sine_ = std::sin(angle_);
    }

    // 0 gives a, 1 gives b.
    glm::qua<Number> at(Number progression) const {
        const Number rest = Number(1) - progression;
        if (isNarrow()) return a_ * narrowShare(rest) + b_ * narrowShare(progression);
        return (a_ * std::sin(rest * angle_) + b_ * std::sin(progression * angle_)) / sine_;
    }

private:
    // For rotations below some 23 degrees, where acos() and the division by the sine lose digits: a series is exact
    // there, and faster.
    bool isNarrow() const { return cosineLessOne_ >= Number(-0.02); }

    // sin(t angle) / sin(angle) as a series in cos(angle) - 1 (D. Eberly, "A Fast and Accurate Algorithm for Computing
    // SLERP", 2011); six terms leave less than 1e-14.
    Number narrowShare(Number t) const {
        Number sum(1);
        for (int i = 6; i > 0; --i) {
            const auto n = static_cast<Number>(i);
            sum = Number(1) +
                  (t * t - n * n) * (Number(1) / (n * (Number(2) * n + Number(1)))) * cosineLessOne_ * sum;
        }
        return t * sum;
    }

    glm::qua<Number> a_{Number(1), Number(0), Number(0), Number(0)}, b_ = a_;
    Number cosineLessOne_{0};
    Number angle_{0}, sine_{0};  // set unless isNarrow()
};

// Cubic Hermite interpolation from a to b with a tangent at each: the weights of these four at one progression (0 to 1).
// Tangents are the change per second if the curve takes `seconds`; per whole curve if `seconds` is left at 1.
template <typename Number>
struct Hermite {
    explicit Hermite(Number progression, Number seconds = Number(1)) {
        const Number s = progression, s2 = s * s, s3 = s2 * s;
        ofB = Number(3) * s2 - Number(2) * s3;
        ofA = Number(1) - ofB;
        ofLeaving = (s3 - Number(2) * s2 + s) * seconds;
        ofArriving = (s3 - s2) * seconds;
    }

    template <typename Value>
    Value value(const Value& a, const Value& leaving, const Value& b, const Value& arriving) const {
        return a * ofA + leaving * ofLeaving + b * ofB + arriving * ofArriving;
    }

    Number ofA, ofLeaving, ofB, ofArriving;
};

// The same curve as coefficients of 1, s, s² and s³ (s: the progression). Tangents are the change per whole curve.
template <typename Value>
std::array<Value, 4> hermitePowers(const Value& a, const Value& leaving, const Value& b,
                                   const Value& arriving) {
    return {a, leaving, (b - a) * Value(3) - leaving * Value(2) - arriving,
            (a - b) * Value(2) + leaving + arriving};
}

}  // namespace walkcycle
