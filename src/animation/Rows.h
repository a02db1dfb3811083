#pragma once

#include <bit>

#include "animation/Float4.h"
#include "walkcycle/animation/JointRows.h"

namespace walkcycle {

// JointRows in registers, to compute with.
struct Rows {
    Float4 x, y, z;
};

// One row of a product: row `a` of the left matrix times matrix `b`.
inline Float4 timesRows(Float4 a, const Rows& b) {
    return splatLane<0>(a) * b.x + splatLane<1>(a) * b.y + splatLane<2>(a) * b.z + onlyLast(a);
}

inline Rows operator*(const Rows& a, const Rows& b) {
    return {timesRows(a.x, b), timesRows(a.y, b), timesRows(a.z, b)};
}

inline Rows load(const JointRows& joint) {
    return std::bit_cast<Rows>(joint);
}

inline void store(const Rows& rows, JointRows& joint) {
    joint = std::bit_cast<JointRows>(rows);
}

}  // namespace walkcycle
