#include "crowd/ClipTimeline.h"

#include <algorithm>

namespace walkcycle {

namespace {

// The weights of a row and of the next one at a time between them. For slerp, sin(t a) / sin(a) is a power series in
// cos(a) - 1 (D. Eberly, "A Fast and Accurate Algorithm for Computing SLERP", 2011). The angle from row to row is small
// (kMaxHalfAngle), so four terms are exact to the precision of a float.
struct Shares {
    static constexpr std::size_t kTerms = 4;

    explicit Shares(float progression) : t(splat(progression)), left(splat(1.0f) - t) {
        for (std::size_t i = 0; i < kTerms; ++i) {
            const auto n = static_cast<float>(i + 1);
            const Float4 scale = splat(1.0f / (n * (2.0f * n + 1.0f)));
            ofNext[i] = (t * t - splat(n * n)) * scale;
            ofRow[i] = (left * left - splat(n * n)) * scale;
        }
    }

    static Float4 series(Float4 first, const std::array<Float4, kTerms>& terms, Float4 cosineLessOne) {
        Float4 sum = splat(1.0f);
        for (std::size_t i = kTerms; i-- > 0;) sum = splat(1.0f) + terms[i] * cosineLessOne * sum;
        return first * sum;
    }

    Float4 t, left;
    std::array<Float4, kTerms> ofRow, ofNext;
};

using Rotations = std::array<Float4, 4>;  // x, y, z, w of four quaternions

template <std::size_t kCount>
void straight(const Float4* row, const Float4* next, Float4 t, std::array<Float4, kCount>& out) {
    for (std::size_t i = 0; i < kCount; ++i) out[i] = row[i] + (next[i] - row[i]) * t;
}

template <std::size_t kCount>
void cubic(const Float4* row, Float4 t, std::array<Float4, kCount>& out) {
    for (std::size_t i = 0; i < kCount; ++i)
        out[i] = row[4 * i] + (row[4 * i + 1] + (row[4 * i + 2] + row[4 * i + 3] * t) * t) * t;
}

Float4 dot(const Float4* a, const Float4* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

// No sign needs to be flipped: TimelineWriter stores rotations so that dot(a, b) is not negative.
void slerp(const Float4* a, const Float4* b, const Shares& shares, Rotations& out) {
    const Float4 cosineLessOne = dot(a, b) - splat(1.0f);
    const Float4 ofA = Shares::series(shares.left, shares.ofRow, cosineLessOne);
    const Float4 ofB = Shares::series(shares.t, shares.ofNext, cosineLessOne);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] * ofA + b[i] * ofB;
}

// translate * rotate * scale of four joints, as three rows each. The quaternions may have any length but zero.
void compose(const Rotations& q, const std::array<Float4, 3>& position, const std::array<Float4, 3>& scale,
             const std::array<int, 4>& slots, std::span<Rows> locals) {
    const Float4 twice = splat(2.0f) / dot(q.data(), q.data()), one = splat(1.0f);
    const Float4 x2 = q[0] * twice, y2 = q[1] * twice, z2 = q[2] * twice;
    const Float4 xx = q[0] * x2, yy = q[1] * y2, zz = q[2] * z2;
    const Float4 xy = q[0] * y2, xz = q[0] * z2, yz = q[1] * z2;
    const Float4 wx = q[3] * x2, wy = q[3] * y2, wz = q[3] * z2;
    std::array<std::array<Float4, 4>, 3> rows{{
        {(one - (yy + zz)) * scale[0], (xy - wz) * scale[1], (xz + wy) * scale[2], position[0]},
        {(xy + wz) * scale[0], (one - (xx + zz)) * scale[1], (yz - wx) * scale[2], position[1]},
        {(xz - wy) * scale[0], (yz + wx) * scale[1], (one - (xx + yy)) * scale[2], position[2]},
    }};
    for (auto& row : rows) transpose(row[0], row[1], row[2], row[3]);
    for (std::size_t lane = 0; lane < 4; ++lane)
        locals[static_cast<std::size_t>(slots[lane])] = {rows[0][lane], rows[1][lane], rows[2][lane]};
}

}  // namespace

// The last row that is not later than `seconds`. Most tables have evenly spaced rows; then the guess is right.
std::size_t ClipTimeline::rowAt(double seconds) const {
    const auto guess = static_cast<std::size_t>((seconds - times.front()) * rowsPerSecond);
    if (guess + 1 < times.size() && times[guess] <= seconds && seconds < times[guess + 1]) return guess;
    return static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), seconds) - times.begin()) -
           1;
}

void ClipTimeline::sample(double seconds, std::span<Rows> locals) const {
    const double within = std::clamp(seconds, times.front(), times.back());
    const std::size_t at = rowAt(within);
    const double length = at + 1 < times.size() ? times[at + 1] - times[at] : 0.0;  // 0: the last row
    const Shares shares(length > 0.0 ? static_cast<float>((within - times[at]) / length) : 0.0f);
    const Float4* row = numbers.data() + at * width;
    const Float4* next = row + width;
    for (const Group& group : groups) {
        Rotations rotation = group.rotation;
        std::array<Float4, 3> position = group.position, scale = group.scale;
        const auto blend = [&](int place, auto& out) {
            if (place == Group::kNoPlace) return;
            if (group.isCubic)
                cubic(row + place, shares.t, out);
            else
                straight(row + place, next + place, shares.t, out);
        };
        blend(group.positionAt, position);
        blend(group.scaleAt, scale);
        if (group.rotationAt != Group::kNoPlace) {
            if (group.isCubic)
                cubic(row + group.rotationAt, shares.t, rotation);
            else
                slerp(row + group.rotationAt, next + group.rotationAt, shares, rotation);
        }
        compose(rotation, position, scale, group.slots, locals);
    }
    for (const MatrixJoint& joint : matrices) {
        std::array<Float4, 3> rows;
        straight(row + joint.at, next + joint.at, shares.t, rows);
        locals[static_cast<std::size_t>(joint.slot)] = {rows[0], rows[1], rows[2]};
    }
}

std::size_t ClipTimeline::bytes() const {
    return sizeof *this + times.size() * sizeof(double) + numbers.size() * sizeof(Float4) +
           groups.size() * sizeof(Group) + matrices.size() * sizeof(MatrixJoint);
}

}  // namespace walkcycle
