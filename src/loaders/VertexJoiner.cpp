#include "loaders/VertexJoiner.h"

#include <algorithm>
#include <bit>

namespace walkcycle {
namespace {

constexpr std::uint32_t kEmpty = ~std::uint32_t{0};

// The bits of a number; adding zero makes -0 the 0 that it equals.
std::uint64_t bitsOf(float number) {
    return std::bit_cast<std::uint32_t>(number + 0.0f);
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t bits) {
    hash = (hash ^ bits) * 0xFF51AFD7ED558CCDull;
    return hash ^ (hash >> 32);
}

std::uint32_t hashOf(std::uint32_t position, const float* attributes, std::size_t count) {
    std::uint64_t hash = mixed(position, bitsOf(attributes[0]) << 32);  // there is always a normal
    std::size_t i = 1;
    for (; i + 1 < count; i += 2) hash = mixed(hash, bitsOf(attributes[i]) | bitsOf(attributes[i + 1]) << 32);
    if (i < count) hash = mixed(hash, bitsOf(attributes[i]));
    return static_cast<std::uint32_t>(hash);
}

}  // namespace

VertexJoiner::VertexJoiner(std::size_t attributeCount, std::size_t expectedCorners)
    : attributeCount_(attributeCount) {
    // Characters share a vertex among four to six corners; tables at most half full stay fast.
    table_.assign(std::bit_ceil(std::max<std::size_t>(expectedCorners / 3 * 2, 16)), kEmpty);
}

std::uint32_t VertexJoiner::add(std::uint32_t position, const float* attributes) {
    const std::uint32_t hash = hashOf(position, attributes, attributeCount_);
    std::size_t slot = hash & (table_.size() - 1);
    for (; table_[slot] != kEmpty; slot = (slot + 1) & (table_.size() - 1)) {
        const std::uint32_t vertex = table_[slot];
        if (hashes_[vertex] == hash && positions_[vertex] == position &&
            std::equal(attributes, attributes + attributeCount_, this->attributes(vertex)))
            return vertex;
    }
    const auto vertex = static_cast<std::uint32_t>(positions_.size());
    table_[slot] = vertex;
    positions_.push_back(position);
    hashes_.push_back(hash);
    attributes_.insert(attributes_.end(), attributes, attributes + attributeCount_);
    if (positions_.size() * 2 > table_.size()) grow();
    return vertex;
}

void VertexJoiner::grow() {
    table_.assign(table_.size() * 2, kEmpty);
    for (std::uint32_t vertex = 0; vertex < hashes_.size(); ++vertex) {
        std::size_t slot = hashes_[vertex] & (table_.size() - 1);
        while (table_[slot] != kEmpty) slot = (slot + 1) & (table_.size() - 1);
        table_[slot] = vertex;
    }
}

}  // namespace walkcycle
