#pragma once

#include <cstdint>
#include <vector>

namespace walkcycle {

// Makes vertices of corners: those that stand at one position and look the same in every attribute (by value, not by
// index: exporters repeat equal values) are one vertex.
class VertexJoiner {
public:
    // `attributeCount` numbers per corner, one at least; `expectedCorners` is only a hint.
    VertexJoiner(std::size_t attributeCount, std::size_t expectedCorners);

    // The vertex of a corner. `attributes` points to attributeCount finite numbers.
    std::uint32_t add(std::uint32_t position, const float* attributes);

    std::size_t vertexCount() const { return positions_.size(); }
    std::vector<std::uint32_t> takePositions() { return std::move(positions_); }
    const float* attributes(std::size_t vertex) const {
        return attributes_.data() + vertex * attributeCount_;
    }

private:
    void grow();

    std::size_t attributeCount_;
    std::vector<std::uint32_t> positions_;
    std::vector<float> attributes_;
    std::vector<std::uint32_t> hashes_;  // per vertex, so that growing needs no second look at the values
    std::vector<std::uint32_t> table_;   // open addressing: vertices, kEmpty between them; a power of two
};

}  // namespace walkcycle
