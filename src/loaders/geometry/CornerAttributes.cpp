#include "loaders/geometry/CornerAttributes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <glm/geometric.hpp>

#include "loaders/geometry/CornerLocation.h"
#include "model/SmoothNormals.h"

namespace walkcycle {
namespace {

constexpr std::size_t kNormalSize = 3, kTexCoordSize = 2, kColorSize = 4;

glm::vec3 unit(const glm::vec3& normal) {
    const float squared = glm::dot(normal, normal);
    if (std::abs(squared - 1.0f) < 1e-6f) return normal;
    return squared > 1e-6f && squared < 1e6f ? normal / std::sqrt(squared) : unitOrZero(glm::dvec3(normal));
}

}  // namespace

void BadIndices::report(const PrimitiveCorners& primitive, const CornerInput& input, const char* semantic,
                        Diagnostics& diagnostics) const {
    if (count_ == 0) return;
    const CornerLocation location = findCorner(primitive, corner_, input.offset);
    diagnostics.report(
        Code::IndexOutOfRange, location.element,
        {std::to_string(count_), semantic, std::to_string(input.source->count()), std::to_string(index_)},
        location.line);
}

CornerAttributes::CornerAttributes(const std::vector<PrimitiveCorners>& primitives) {
    for (const PrimitiveCorners& primitive : primitives) {
        hasColors_ = hasColors_ || primitive.inputs.color.source;
        for (const CornerInput& input : primitive.inputs.texCoords)
            if (std::find(sets_.begin(), sets_.end(), input.set) == sets_.end()) sets_.push_back(input.set);
    }
    missing_.assign(kNormalSize + kTexCoordSize * sets_.size(), 0.0f);
    if (hasColors_) missing_.insert(missing_.end(), kColorSize, 1.0f);
    values_ = missing_;
}

std::size_t CornerAttributes::targetOf(int set) const {
    const auto index = std::find(sets_.begin(), sets_.end(), set) - sets_.begin();
    return kNormalSize + kTexCoordSize * static_cast<std::size_t>(index);
}

void CornerAttributes::begin(const PrimitiveCorners& primitive) {
    primitive_ = &primitive;
    streams_.clear();
    values_ = missing_;
    if (primitive.kind != Primitive::Lines) addStream(primitive.inputs.normal, "NORMAL", 0, kNormalSize);
    for (const CornerInput& input : primitive.inputs.texCoords)
        addStream(input, "TEXCOORD", targetOf(input.set), kTexCoordSize);
    addStream(primitive.inputs.color, "COLOR", values_.size() - kColorSize, kColorSize);
}

void CornerAttributes::addStream(const CornerInput& input, const char* semantic, std::size_t target,
                                 std::size_t width) {
    if (!input.source) return;
    const FloatSource& source = *input.source;
    streams_.push_back({&input,
                        semantic,
                        target,
                        std::min(width, source.width),
                        source.values.data(),
                        source.count(),
                        source.width,
                        {}});
}

void CornerAttributes::report(Diagnostics& diagnostics) const {
    for (const Stream& stream : streams_)
        stream.bad.report(*primitive_, *stream.input, stream.semantic, diagnostics);
}

void CornerAttributes::store(MeshData& mesh, const float* vertices) const {
    const std::size_t vertexCount = mesh.vertexCount();
    mesh.normals.resize(vertexCount);
    mesh.colors.resize(hasColors_ ? vertexCount : 0);
    for (const int set : sets_) mesh.texCoordSets.push_back({set, std::vector<glm::vec2>(vertexCount)});
    for (std::size_t v = 0; v < vertexCount; ++v, vertices += count()) {
        mesh.normals[v] = unit({vertices[0], vertices[1], vertices[2]});
        const float* at = vertices + kNormalSize;
        for (TexCoordSet& set : mesh.texCoordSets) {
            set.coords[v] = {at[0], at[1]};
            at += kTexCoordSize;
        }
        if (hasColors_) mesh.colors[v] = {at[0], at[1], at[2], at[3]};
    }
}

}  // namespace walkcycle
