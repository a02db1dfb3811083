#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "animation/Rows.h"

namespace walkcycle {

// Part of a clip, laid out for fast sampling: all numbers for one time lie side by side in memory, four joints to a
// register. (TimelineBuilder makes this from an Animation.)
//
// It is a table with a row for each time at which any of its channels has a key. A row holds the values of all channels at
// that time, also of those without a key there. A sample blends two neighbouring rows.
struct ClipTimeline {
    // A joint rotates by at most twice this angle (radians) from a row to the next; the slerp relies on it.
    static constexpr double kMaxHalfAngle = 0.35;

    // Four joints. Values that never change are stored here; the others in each row, at these offsets (in Float4s).
    struct Group {
        static constexpr int kNoPlace = -1;  // the value never changes
        std::array<int, 4> slots{};  // where they are written; a group of fewer joints repeats its last one
        int rotationAt = kNoPlace, positionAt = kNoPlace, scaleAt = kNoPlace;
        // If true, a row holds each number's curve to the next row: coefficients of 1, s, s², s³.
        bool isCubic = false;
        std::array<Float4, 4> rotation{};
        std::array<Float4, 3> position{}, scale{};
    };
    // A joint whose transform only a matrix can hold. A row has three rows of that matrix, at the offset `at`.
    struct MatrixJoint {
        int slot = 0, at = 0;
    };

    std::vector<double> times;  // of the rows, rising; if two rows share a time, the second counts from it on
    double rowsPerSecond = 0.0;   // their average; for the guess of rowAt()
    std::size_t width = 0;        // of a row, in Float4s
    std::vector<Float4> numbers;  // row after row; the last one twice, so that each has a next
    std::vector<Group> groups;
    std::vector<MatrixJoint> matrices;

    // Writes the local transform of each of its joints to locals[slot]. `seconds` is a finite time of the document's
    // timeline; before the first row the first one holds, after the last row the last one.
    void sample(double seconds, std::span<Rows> locals) const;

    std::size_t bytes() const;  // of memory in use

private:
    std::size_t rowAt(double seconds) const;
};

}  // namespace walkcycle
