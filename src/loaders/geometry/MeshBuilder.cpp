#include "loaders/geometry/MeshBuilder.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "loaders/geometry/CornerAttributes.h"
#include "loaders/geometry/PolygonShape.h"
#include "loaders/geometry/Triangulation.h"
#include "loaders/geometry/VertexJoiner.h"
#include "model/SmoothNormals.h"

namespace walkcycle {
namespace {

// A normal with a smaller squared length has no meaningful direction, and counts as missing.
constexpr float kLeastNormalSquared = 1e-20f;
std::size_t cornersOf(const std::vector<PrimitiveCorners>& primitives) {
    std::size_t corners = 0;
    for (const PrimitiveCorners& primitive : primitives) corners += primitive.cornerCount();
    return corners;
}

class MeshAssembler {
public:
    MeshAssembler(const std::vector<PrimitiveCorners>& primitives, LoadedMesh& loaded,
                  const LoadContext& context)
        : loaded_(loaded),
          mesh_(loaded.mesh),
          context_(context),
          attributes_(primitives),
          joiner_(attributes_.count(), positionsOf(primitives), cornersOf(primitives)) {}

    // All primitives' positions are added before the first part, because faces of different materials smooth
    // into each other.
    void addPositions(const PrimitiveCorners& primitive);
    void addPart(const PrimitiveCorners& primitive);
    void finish();
    // The index in MeshData::positions of the first entry of a source. Appends the source if it is new.
    std::uint32_t positionBase(const FloatSource& source);

private:
    static std::size_t positionsOf(const std::vector<PrimitiveCorners>& primitives) {
        return primitives.empty() ? 0 : primitives.front().inputs.position.source->count();
    }

    void addLines(const PrimitiveCorners& primitive);
    void addFaces(const PrimitiveCorners& primitive);
    bool joinRing(const PrimitiveCorners& primitive, const Ring& ring, std::size_t meshCorner);
    std::uint32_t vertexOf(const PrimitiveCorners& primitive, std::size_t corner, std::size_t meshCorner);
    bool useNormal(float* normal, std::size_t meshCorner);
    void cutFace(std::span<const Ring> rings);
    void addIndices(std::span<const std::uint32_t> corners);
    std::uint32_t positionAt(const PrimitiveCorners& primitive, std::size_t corner, std::size_t count);
    void report(const PrimitiveCorners& primitive);

    LoadedMesh& loaded_;
    MeshData& mesh_;
    const LoadContext& context_;
    CornerAttributes attributes_;
    VertexJoiner joiner_;
    std::vector<std::pair<const FloatSource*, std::uint32_t>> positionSources_;
    std::size_t firstCorner_ = 0, firstRing_ = 0;  // of the current primitive, in loaded_.faces
    // Per position: the last corner that became a vertex there, plus one; 0 if there is none. Corners with an
    // index out of range or without a usable normal do not count.
    std::vector<std::uint32_t> lastJoined_;
    BadIndices badPositions_;
    std::size_t zeroNormals_ = 0, flatFaces_ = 0;
    std::vector<glm::vec3> madeNormals_;  // per corner of the faces; computed when the first one is needed
    Triangulation triangulation_;
    std::vector<glm::vec3> points_;  // the polygon that is cut at the moment, and the corner of each point
    std::vector<std::uint32_t> pointCorners_, ringEnds_;
};

// Nearly every mesh has one position source. The entries of a second one follow those of the first.
std::uint32_t MeshAssembler::positionBase(const FloatSource& source) {
    for (const auto& [known, base] : positionSources_)
        if (known == &source) return base;
    const auto base = static_cast<std::uint32_t>(mesh_.positions.size());
    positionSources_.emplace_back(&source, base);
    mesh_.positions.resize(base + source.count(), glm::vec3(0.0f));  // two-dimensional positions get z = 0
    for (std::size_t i = 0; i < source.count(); ++i)
        std::copy_n(source[i], std::min<std::size_t>(source.width, 3), &mesh_.positions[base + i].x);
    mesh_.positionUsed.resize(mesh_.positions.size(), false);
    return base;
}

// The corner's position within its source, which has `count` positions; kNoPosition, and counted, if the
// index is out of range.
std::uint32_t MeshAssembler::positionAt(const PrimitiveCorners& primitive, std::size_t corner,
                                        std::size_t count) {
    const std::int32_t index = primitive.corner(corner)[primitive.inputs.position.offset];
    if (index >= 0 && static_cast<std::size_t>(index) < count) return static_cast<std::uint32_t>(index);
    badPositions_.add(corner, index);
    return kNoPosition;
}

void MeshAssembler::addPositions(const PrimitiveCorners& primitive) {
    const std::uint32_t base = positionBase(*primitive.inputs.position.source);
    if (primitive.kind == Primitive::Lines) return;
    badPositions_ = {};
    MeshFaces& faces = loaded_.faces;
    const auto firstCorner = static_cast<std::uint32_t>(faces.cornerPositions.size());
    const std::size_t corners = primitive.cornerCount(), count = primitive.inputs.position.source->count();
    faces.cornerPositions.resize(firstCorner + corners, kNoPosition);
    for (std::size_t c = 0; c < corners; ++c) {
        const std::uint32_t position = positionAt(primitive, c, count);
        if (position != kNoPosition) faces.cornerPositions[firstCorner + c] = base + position;
    }
    badPositions_.report(primitive, primitive.inputs.position, "VERTEX", context_.diagnostics);
    for (const Ring& ring : primitive.rings)
        faces.rings.push_back({ring.firstCorner + firstCorner, ring.cornerCount, ring.hole});
    loaded_.cornerVertices.resize(faces.cornerPositions.size(), kNoVertex);
    loaded_.hasNormals = loaded_.hasNormals || primitive.inputs.normal.source;
}

void MeshAssembler::addPart(const PrimitiveCorners& primitive) {
    context_.checkCancelled(primitive.element);
    MeshPart part;
    part.primitive = primitive.kind;
    part.firstIndex = static_cast<std::uint32_t>(mesh_.indices.size());
    part.materialSymbol = primitive.element.attribute("material");
    attributes_.begin(primitive);
    badPositions_ = {};
    zeroNormals_ = flatFaces_ = 0;
    if (primitive.kind == Primitive::Lines)
        addLines(primitive);
    else
        addFaces(primitive);
    attributes_.report(context_.diagnostics);
    report(primitive);
    part.indexCount = static_cast<std::uint32_t>(mesh_.indices.size()) - part.firstIndex;
    if (part.indexCount > 0) mesh_.parts.push_back(std::move(part));
}

void MeshAssembler::addLines(const PrimitiveCorners& primitive) {
    const std::uint32_t base = positionBase(*primitive.inputs.position.source);
    const std::size_t count = primitive.inputs.position.source->count();
    for (const Ring& line : primitive.rings) {
        const std::uint32_t from = positionAt(primitive, line.firstCorner, count);
        const std::uint32_t to = positionAt(primitive, line.firstCorner + 1, count);
        if (from == kNoPosition || to == kNoPosition) continue;
        mesh_.indices.push_back(joiner_.add(base + from, attributes_.read(line.firstCorner)));
        mesh_.indices.push_back(joiner_.add(base + to, attributes_.read(line.firstCorner + 1)));
    }
    if (!loaded_.hasNormals) loaded_.indexCorners.resize(mesh_.indices.size(), kNoCorner);
    badPositions_.report(primitive, primitive.inputs.position, "VERTEX", context_.diagnostics);
}

void MeshAssembler::addFaces(const PrimitiveCorners& primitive) {
    const std::span<const Ring> rings(loaded_.faces.rings);
    // Joining and cutting a ring counts as much work as reading it did, measured by the bytes of its text
    // (see LoadProgress).
    const double workOfRing =
        textBytes(primitive) / static_cast<double>(std::max<std::size_t>(1, primitive.rings.size()));
    lastJoined_.resize(mesh_.positions.size(), 0);
    for (std::size_t r = 0; r < primitive.rings.size();) {
        const std::size_t end = endOfFace(primitive.rings, r);
        const std::size_t first = r;
        for (; r < end; ++r) {
            // If the outline has a corner without a position, the polygon is skipped; if a hole has one, only
            // that hole.
            const bool whole =
                joinRing(primitive, primitive.rings[r], firstCorner_ + primitive.rings[r].firstCorner);
            if (!whole && r == first) break;
        }
        if (r == end) cutFace(rings.subspan(firstRing_ + first, end - first));
        context_.advance(workOfRing * static_cast<double>(end - first));
        r = end;
    }
    firstCorner_ += primitive.cornerCount();
    firstRing_ += primitive.rings.size();
}

// Makes the vertices of a ring's corners. Returns false, and makes none, if a corner has no position.
bool MeshAssembler::joinRing(const PrimitiveCorners& primitive, const Ring& ring, std::size_t meshCorner) {
    const std::uint32_t* positions = loaded_.faces.cornerPositions.data() + meshCorner;
    if (std::find(positions, positions + ring.cornerCount, kNoPosition) != positions + ring.cornerCount)
        return false;
    for (std::uint32_t i = 0; i < ring.cornerCount; ++i) {
        loaded_.cornerVertices[meshCorner + i] = vertexOf(primitive, ring.firstCorner + i, meshCorner + i);
        mesh_.positionUsed[positions[i]] = true;
    }
    return true;
}

// The vertex of a corner. Fast path: most corners have the same indices as the last corner at their position,
// and so are the same vertex.
std::uint32_t MeshAssembler::vertexOf(const PrimitiveCorners& primitive, std::size_t corner,
                                      std::size_t meshCorner) {
    const std::uint32_t position = loaded_.faces.cornerPositions[meshCorner];
    std::uint32_t& last = lastJoined_[position];
    if (last > firstCorner_) {
        const std::int32_t* const own = primitive.corner(corner);
        const std::int32_t* const other = primitive.corner(last - 1 - firstCorner_);
        std::size_t same = 0;
        while (same < primitive.inputs.stride && own[same] == other[same]) ++same;
        if (same == primitive.inputs.stride) return loaded_.cornerVertices[last - 1];
    }
    float* const attributes = attributes_.read(corner);
    const bool isPlain = useNormal(attributes, meshCorner) && attributes_.isWhole();
    if (isPlain) last = static_cast<std::uint32_t>(meshCorner + 1);
    return joiner_.add(position, attributes);
}

// Returns false if the corner has no usable normal. Then writes the computed normal of the corner instead.
bool MeshAssembler::useNormal(float* normal, std::size_t meshCorner) {
    if (normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2] > kLeastNormalSquared)
        return true;
    ++zeroNormals_;
    if (madeNormals_.empty()) madeNormals_ = smoothNormals(loaded_.faces, mesh_.positions, mesh_.positions);
    std::copy_n(&madeNormals_[meshCorner].x, 3, normal);
    return false;
}

// Appends the triangles of a polygon. `rings` are its outline and its holes, whose corners are vertices
// already.
void MeshAssembler::cutFace(std::span<const Ring> rings) {
    const Ring& outline = rings[0];
    const std::uint32_t* vertices = loaded_.cornerVertices.data();
    const std::uint32_t c0 = outline.firstCorner;
    const PolygonShape shape =
        shapeOf(std::span(loaded_.faces.cornerPositions).subspan(outline.firstCorner, outline.cornerCount),
                mesh_.positions);
    if (!shape.hasArea) ++flatFaces_;
    // Fast path: nearly all polygons are triangles and plain quads.
    if (rings.size() == 1 && outline.cornerCount == 3) return addIndices(std::array{c0, c0 + 1, c0 + 2});
    if (rings.size() == 1 && outline.cornerCount == 4 && shape.isPlain)
        return addIndices(std::array{c0, c0 + 1, c0 + 2, c0, c0 + 2, c0 + 3});
    points_.clear();
    pointCorners_.clear();
    ringEnds_.clear();
    for (const Ring& ring : rings) {
        if (vertices[ring.firstCorner] == kNoVertex) continue;  // a hole with a corner that has no position
        for (std::uint32_t c = ring.firstCorner; c < ring.firstCorner + ring.cornerCount; ++c) {
            points_.push_back(mesh_.positions[loaded_.faces.cornerPositions[c]]);
            pointCorners_.push_back(c);
        }
        ringEnds_.push_back(static_cast<std::uint32_t>(points_.size()));
    }
    for (const std::uint32_t point : triangulation_.cut(points_, ringEnds_))
        addIndices(std::span(pointCorners_).subspan(point, 1));
}

void MeshAssembler::addIndices(std::span<const std::uint32_t> corners) {
    const std::uint32_t* const vertices = loaded_.cornerVertices.data();
    for (const std::uint32_t corner : corners) mesh_.indices.push_back(vertices[corner]);
    if (!loaded_.hasNormals)
        loaded_.indexCorners.insert(loaded_.indexCorners.end(), corners.begin(), corners.end());
}

void MeshAssembler::report(const PrimitiveCorners& primitive) {
    const std::string name(primitive.element.name());
    if (flatFaces_ > 0)
        context_.diagnostics.report(Code::ZeroAreaFaces, primitive.element,
                                    {std::to_string(flatFaces_), name});
    if (zeroNormals_ > 0 && primitive.inputs.normal.source)
        context_.diagnostics.report(Code::NormalsInvalid, primitive.element,
                                    {std::to_string(zeroNormals_), name});
}

void MeshAssembler::finish() {
    mesh_.vertexPositions = joiner_.takePositions();
    attributes_.store(mesh_, joiner_.attributes(0));
}

}  // namespace

void buildMesh(const PrimitiveInputs& vertices, const std::vector<PrimitiveCorners>& primitives,
               LoadedMesh& loaded, const LoadContext& context) {
    MeshAssembler assembler(primitives, loaded, context);
    // Reserves once for all primitives: a reserve() per primitive would copy what is there each time.
    std::size_t rings = 0;
    for (const PrimitiveCorners& primitive : primitives) rings += primitive.rings.size();
    loaded.mesh.indices.reserve(cornersOf(primitives));
    loaded.faces.rings.reserve(rings);
    if (vertices.usable()) assembler.positionBase(*vertices.position.source);
    for (const PrimitiveCorners& primitive : primitives) assembler.addPositions(primitive);
    for (const PrimitiveCorners& primitive : primitives) assembler.addPart(primitive);
    assembler.finish();
}

}  // namespace walkcycle
