#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "loaders/geometry/PrimitiveReader.h"

namespace walkcycle {

// The indices of one input that are out of range. They are counted, and reported once per primitive.
class BadIndices {
public:
    void add(std::size_t corner, std::int32_t index) {
        if (count_++ == 0) corner_ = corner, index_ = index;
    }
    // Reports how many they are, at the line of the first one. `input` is the input that they belong to.
    void report(const PrimitiveCorners& primitive, const CornerInput& input, const char* semantic,
                Diagnostics& diagnostics) const;

private:
    std::size_t count_ = 0;
    std::size_t corner_ = 0;
    std::int32_t index_ = 0;
};

// Reads the attributes of corners: all that a corner has beside its position. The values have the same layout
// for all primitives of a mesh: three numbers for the normal, two for each texture coordinate set, four for
// the colour if any primitive has colours.
class CornerAttributes {
public:
    explicit CornerAttributes(const std::vector<PrimitiveCorners>& primitives);

    std::size_t count() const { return values_.size(); }

    void begin(const PrimitiveCorners& primitive);
    // The values of one corner (an index into PrimitiveCorners), valid until the next call. What the
    // primitive does not have, or gives by an index out of range, is zero (normals and texture coordinates)
    // or white (colours).
    float* read(std::size_t corner);
    bool isWhole() const { return isWhole_; }     // all indices of the corner read last were in range
    void report(Diagnostics& diagnostics) const;  // the indices out of range since begin()

    // Fills the texture coordinates, colours and normals (of unit length) of the mesh. `vertices` are the
    // values of its vertices, one after another.
    void store(MeshData& mesh, const float* vertices) const;

private:
    struct Stream {
        const CornerInput* input;
        const char* semantic;
        std::size_t target;   // index of its first number in values_
        std::size_t width;    // how many numbers it has
        const float* values;  // of the source: `count` entries of `stride` numbers
        std::size_t count, stride;
        BadIndices bad;
    };
    static void copyFew(const float* from, std::size_t count, float* to);
    std::size_t targetOf(int set) const;
    void addStream(const CornerInput& input, const char* semantic, std::size_t target, std::size_t width);

    std::vector<int> sets_;
    bool hasColors_ = false;
    std::vector<float> values_, missing_;  // of the current corner; of a corner without any attributes
    const PrimitiveCorners* primitive_ = nullptr;
    std::vector<Stream> streams_;
    bool isWhole_ = true;
};

// Copies one to four numbers without a function call. (std::copy_n with a count known only at run time makes
// one.)
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
    values_[0] = values_[1] = values_[2] = 0.0f;  // the caller may have written a normal here
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
