#include "loaders/geometry/GeometryLoader.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "loaders/geometry/MeshBuilder.h"
#include "loaders/geometry/PrimitiveKind.h"
#include "loaders/geometry/PrimitiveReader.h"
#include "loaders/quirks/Dialect.h"
#include "loaders/quirks/Extras.h"
#include "loaders/text/NumberParser.h"
#include "model/SmoothNormals.h"

namespace walkcycle {
namespace {

// <convex_mesh convex_hull_of> may name a geometry with a <convex_mesh> of its own. So many may follow each
// other; more are taken for a loop.
constexpr int kMostHulls = 16;

// The element that holds the sources and primitives: <mesh>, <convex_mesh>, or the mesh of the geometry whose
// convex hull is asked for (the hull itself is not computed). Nothing, and reported, if there is none.
XmlNode findMesh(XmlNode geometry, const LoadContext& context, int hulls = 0) {
    if (const XmlNode mesh = geometry.child("mesh")) return mesh;
    if (const XmlNode convex = geometry.child("convex_mesh")) {
        if (!convex.has("convex_hull_of")) return convex;
        const std::string url(convex.attribute("convex_hull_of"));
        if (hulls == kMostHulls) {
            context.diagnostics.report(Code::ReferenceLoop, convex, {"convex_mesh", url});
            return {};
        }
        const XmlNode whole = context.documents.follow(convex, "convex_hull_of", "geometry");
        if (whole && hulls == 0) context.diagnostics.report(Code::ConvexHullOf, convex, {url});
        return whole ? findMesh(whole, context, hulls + 1) : XmlNode{};
    }
    for (const char* curve : {"spline", "brep"})
        if (const XmlNode element = geometry.child(curve)) {
            context.diagnostics.report(Code::ShapeNotDrawn, element, {curve});
            return {};
        }
    context.diagnostics.report(Code::MissingElement, geometry, {"geometry", "mesh"});
    return {};
}

bool isDoubleSided(XmlNode geometry, XmlNode mesh, Dialects& dialects) {
    if (!dialects.follows(Quirk::ExtraDoubleSided, geometry)) return false;
    for (const XmlNode owner : {geometry, mesh})
        for (XmlNode technique : extraTechniques(owner)) {
            double value = 0.0;
            if (!parseNumber(technique.child("double_sided").text(), value) || value == 0.0) continue;
            dialects.note(Quirk::ExtraDoubleSided, technique);
            return true;
        }
    return false;
}

std::vector<glm::vec3> readPositionNormals(const PrimitiveInputs& vertices) {
    std::vector<glm::vec3> normals;
    const auto& source = vertices.normal.source;
    if (!source || !vertices.usable()) return normals;
    normals.resize(vertices.position.source->count(), glm::vec3(0.0f));
    for (std::size_t i = 0; i < std::min(normals.size(), source->count()); ++i) {
        std::copy_n((*source)[i], std::min<std::size_t>(source->width, 3), &normals[i].x);
        normals[i] = unitOrZero(glm::dvec3(normals[i]));
    }
    return normals;
}

}  // namespace

LoadedMesh loadGeometry(XmlNode geometry, const LoadContext& context) {
    LoadedMesh loaded;
    loaded.mesh.id = geometry.id();
    loaded.mesh.name = geometry.attribute("name");
    const XmlNode mesh = findMesh(geometry, context);
    if (!mesh) return loaded;
    loaded.mesh.doubleSided = isDoubleSided(geometry, mesh, context.dialects);

    Vertices vertices;
    if (const XmlNode element = mesh.child("vertices"))
        vertices = readVertices(element, context);
    else
        context.diagnostics.report(Code::MissingElement, mesh, {std::string(mesh.name()), "vertices"});
    loaded.positionNormals = readPositionNormals(vertices.inputs);

    std::vector<PrimitiveCorners> primitives;
    for (XmlNode child : mesh.children()) {
        if (!primitiveKindOf(child)) continue;
        context.checkCancelled(child);
        PrimitiveCorners primitive = readPrimitive(child, vertices, context);
        if (primitive.inputs.usable()) primitives.push_back(std::move(primitive));
    }
    buildMesh(vertices.inputs, primitives, loaded, context);
    return loaded;
}

}  // namespace walkcycle
