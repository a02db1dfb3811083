#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "loaders/geometry/PrimitiveReader.h"

namespace walkcycle {

// Indices of one input that lead nowhere: counted, and told once per primitive.
class BadIndices {
public:
    void add(std::size_t corner, std::int32_t index) {
        if (count_++ == 0) corner_ = corner, index_ = index;
    }
    // Says so, with the line of the first. `input` is the one that they are of.
    void report(const PrimitiveCorners& primitive, const CornerInput& input, const char* semantic,
                Diagnostics& diagnostics) const;

private:
    std::size_t count_ = 0;
    std::size_t corner_ = 0;
    std::int32_t index_ = 0;
};

// Reads what a corner has beside its position, in the layout that all vertices of a mesh share: three numbers of the
// normal, two for each texture coordinate set, four of the colour if any primitive has colours.
class CornerAttributes {
public:
    explicit CornerAttributes(const std::vector<PrimitiveCorners>& primitives);

    std::size_t count() const { return values_.size(); }

    void begin(const PrimitiveCorners& primitive);
    // The numbers of a corner, until the next call. The normal is zero where the file has none that can be used; other
    // things that are missing are zero, colours white.
    float* read(std::size_t corner);
    bool isWhole() const { return isWhole_; }     // all indices of the corner read last led somewhere
    void report(Diagnostics& diagnostics) const;  // what was wrong with the indices since begin()

    // Gives the mesh its texture coordinates, colours and normals (of unit length) from the joined vertices' numbers.
    void store(MeshData& mesh, const float* vertices) const;

private:
    struct Stream {
        const CornerInput* input;
        const char* semantic;
        std::size_t target;   // the first of its numbers among the values
        std::size_t width;    // how many there are
        const float* values;  // of the source: `count` entries, each `stride` numbers
        std::size_t count, stride;
        BadIndices bad;
    };
    static void copyFew(const float* from, std::size_t count, float* to);
    std::size_t targetOf(int set) const;
    void addStream(const CornerInput& input, const char* semantic, std::size_t target, std::size_t width);

    std::vector<int> sets_;
    bool hasColors_ = false;
    std::vector<float> values_, missing_;  // of the current corner; where the primitive has nothing
    const PrimitiveCorners* primitive_ = nullptr;
    std::vector<Stream> streams_;
    bool isWhole_ = true;
};

// Copies one to four numbers without a function call, which a copy of unknown length would be.
inline void CornerAttributes::copyFew(const float* from, std::size_t count, float* to) {
    to[0] = from[0];
    if (count > 1) to[1] = from[1];
    if (count > 2) to[2] = from[2];
    if (count > 3) to[3] = from[3];
}

// Inline: runs once per mesh corner.
inline float* CornerAttributes::read(std::size_t corner) {
    const std::int32_t* indices = primitive_->corner(corner);
    isWhole_ = true;
    values_[0] = values_[1] = values_[2] = 0.0f;  // the caller may have put a normal here
    for (Stream& stream : streams_) {
        const std::int32_t index = indices[stream.input->offset];
        const bool there = index >= 0 && static_cast<std::size_t>(index) < stream.count;
        if (!there) stream.bad.add(corner, index), isWhole_ = false;
        const float* from = there ? stream.values + static_cast<std::size_t>(index) * stream.stride
                                  : missing_.data() + stream.target;
        copyFew(from, stream.width, values_.data() + stream.target);
    }
    return values_.data();
}

}  // namespace walkcycle
