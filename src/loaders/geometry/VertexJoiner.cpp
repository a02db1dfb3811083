#include "loaders/geometry/VertexJoiner.h"

#include <algorithm>
#include <bit>

namespace walkcycle {
namespace {

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

VertexJoiner::VertexJoiner(std::size_t attributeCount, std::size_t expectedPositions,
                           std::size_t expectedCorners)
    : attributeCount_(attributeCount), firstAt_(expectedPositions, kNone) {
    const std::size_t vertices = std::min(expectedPositions, expectedCorners);  // usually there are some more
    positions_.reserve(vertices);
    nextAt_.reserve(vertices);
    attributes_.reserve(vertices * attributeCount);
}

std::uint32_t VertexJoiner::append(std::uint32_t position, const float* attributes) {
    const auto vertex = static_cast<std::uint32_t>(positions_.size());
    positions_.push_back(position);
    nextAt_.push_back(kNone);
    attributes_.insert(attributes_.end(), attributes, attributes + attributeCount_);
    return vertex;
}

// For positions with so many vertices that comparing each would take long.
std::uint32_t VertexJoiner::addToTable(std::uint32_t position, const float* attributes) {
    if (table_.empty()) table_.assign(64, kNone);
    const std::uint32_t hash = hashOf(position, attributes, attributeCount_);
    std::size_t slot = hash & (table_.size() - 1);
    for (; table_[slot] != kNone; slot = (slot + 1) & (table_.size() - 1)) {
        const std::uint32_t vertex = overflowed_[table_[slot]].vertex;
        if (overflowed_[table_[slot]].hash == hash && positions_[vertex] == position &&
            looksLike(vertex, attributes))
            return vertex;
    }
    const std::uint32_t vertex = append(position, attributes);
    table_[slot] = static_cast<std::uint32_t>(overflowed_.size());
    overflowed_.push_back({vertex, hash});
    if (overflowed_.size() * 2 > table_.size()) growTable();
    return vertex;
}

void VertexJoiner::growTable() {
    table_.assign(table_.size() * 2, kNone);
    for (std::uint32_t i = 0; i < overflowed_.size(); ++i) {
        std::size_t slot = overflowed_[i].hash & (table_.size() - 1);
        while (table_[slot] != kNone) slot = (slot + 1) & (table_.size() - 1);
        table_[slot] = i;
    }
}

}  // namespace walkcycle
