#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace walkcycle {

// Joins corners into vertices: corners with the same position and equal attributes are one vertex. Attributes
// are compared by value, because exporters write equal values under different indices.
class VertexJoiner {
public:
    // Each corner has `attributeCount` numbers, at least one. The expected numbers of positions and corners
    // are hints.
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
    // A vertex whose position has too many vertices for a chain.
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
    // The vertices at each position are a linked list: its first vertex per position, the next one per
    // vertex. Nearly all lists have one to six vertices.
    std::vector<std::uint32_t> firstAt_, nextAt_;
    // The vertices beyond the longest chain are found by their hash: table_ has open addressing, a power of
    // two of slots, and holds indices of overflowed_.
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
    constexpr int kLongestChain = 16;  // the middle of a fan with hard edges; longer ones are rare
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
