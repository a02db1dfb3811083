#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "animation/Rows.h"

namespace walkcycle {

// A part of a clip, laid out for sampling it fast: what one moment needs stands side by side in memory, four joints to a
// register. (Animation is the plain form; TimelineBuilder makes this from it.)
//
// It is a table with a row for each time at which one of its channels has a key. A row holds what every channel is at that
// time, also of those without a key there. A moment lies between two rows, which lie side by side.
struct ClipTimeline {
    // Half the angle (radians) that a joint rotates at most from a row to the next; what the blending counts on.
    static constexpr double kMaxHalfAngle = 0.35;

    // Four joints. What of them never changes is here; the rest is in the rows, at these places (in Float4s).
    struct Group {
        static constexpr int kNoPlace = -1;
        std::array<int, 4> slots{};  // where they are written; with fewer than four, the last one fills up
        int rotationAt = kNoPlace, positionAt = kNoPlace, scaleAt = kNoPlace;
        bool isCubic = false;  // for each number a row has its curve to the next row: constant, s, s², s³
        std::array<Float4, 4> rotation{};
        std::array<Float4, 3> position{}, scale{};
    };
    // A joint that only a matrix can hold: three rows of it.
    struct MatrixJoint {
        int slot = 0, at = 0;
    };

    std::vector<double> times;    // of the rows, rising; where two share one, the second rules from it on
    double rowsPerSecond = 0.0;   // if they were evenly spaced
    std::size_t width = 0;        // of a row, in Float4s
    std::vector<Float4> numbers;  // row after row, the last one twice
    std::vector<Group> groups;
    std::vector<MatrixJoint> matrices;

    // Writes the local transforms of its joints to locals[slot]. Before the first row that one holds, after the last the
    // last. `seconds` are of the document's timeline, and finite.
    void sample(double seconds, std::span<Rows> locals) const;

    std::size_t bytes() const;

private:
    std::size_t rowAt(double seconds) const;
};

}  // namespace walkcycle
