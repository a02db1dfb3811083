#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace walkcycle {

// Makes vertices of corners: those that stand at one position and look the same in every attribute (by value, not by
// index: exporters repeat equal values) are one vertex.
class VertexJoiner {
public:
    // `attributeCount` numbers per corner, one at least; how many positions and corners there will be is only a hint.
    VertexJoiner(std::size_t attributeCount, std::size_t expectedPositions, std::size_t expectedCorners);

    // The vertex of a corner. `attributes` points to attributeCount finite numbers.
    std::uint32_t add(std::uint32_t position, const float* attributes);

    std::size_t vertexCount() const { return positions_.size(); }
    std::vector<std::uint32_t> takePositions() { return std::move(positions_); }
    const float* attributes(std::size_t vertex) const {
        return attributes_.data() + vertex * attributeCount_;
    }

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    struct Overflowed {
        std::uint32_t vertex, hash;
    };
    bool looksLike(std::uint32_t vertex, const float* attributes) const;
    std::uint32_t append(std::uint32_t position, const float* attributes);
    std::uint32_t addToTable(std::uint32_t position, const float* attributes);
    void growTable();

    std::size_t attributeCount_;
    std::vector<std::uint32_t> positions_;
    std::vector<float> attributes_;
    // The vertices at a position as a chain: its first, and for each vertex the next. There are one to six mostly.
    std::vector<std::uint32_t> firstAt_, nextAt_;
    // Those that did not fit into a chain, by their hash; the table (open addressing, a power of two) holds indices.
    std::vector<Overflowed> overflowed_;
    std::vector<std::uint32_t> table_;
};

// Inline: these run once per mesh corner.
inline bool VertexJoiner::looksLike(std::uint32_t vertex, const float* wanted) const {
    const float* own = attributes(vertex);
    for (std::size_t i = 0; i < attributeCount_; ++i)
        if (own[i] != wanted[i]) return false;
    return true;
}

inline std::uint32_t VertexJoiner::add(std::uint32_t position, const float* attributes) {
    constexpr int kLongestChain = 16;  // a fan of hard edges; no honest position has many more vertices
    if (position >= firstAt_.size())
        firstAt_.resize(std::max<std::size_t>(position + 1, 2 * firstAt_.size()), kNone);
    std::uint32_t vertex = firstAt_[position], last = kNone;
    for (int i = 0; vertex != kNone; last = vertex, vertex = nextAt_[vertex], ++i) {
        if (i == kLongestChain) return addToTable(position, attributes);
        if (looksLike(vertex, attributes)) return vertex;
    }
    vertex = append(position, attributes);
    (last == kNone ? firstAt_[position] : nextAt_[last]) = vertex;
    return vertex;
}

}  // namespace walkcycle
