#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "loaders/geometry/GeometryLoader.h"
#include "loaders/quirks/Dialect.h"

namespace walkcycle {

// A <geometry> written in the test, read by itself: what became of it, and what was said about it.
struct GeometryFixture {
    // `mesh` is what stands in <mesh>, from line 3 of the document on.
    explicit GeometryFixture(const std::string& mesh)
        : GeometryFixture(document("<mesh>\n" + mesh + "</mesh>"), 0) {}

    static GeometryFixture ofGeometry(const std::string& content) {
        return GeometryFixture(document(content), 0);
    }

    LoadOptions options;
    Diagnostics diagnostics;
    LoadedMesh loaded;

    const MeshData& mesh() const { return loaded.mesh; }

    // Where each index stands, as "x,y,z" would be too much to read: the positions' indices, in drawing order.
    std::vector<std::uint32_t> drawnPositions() const {
        std::vector<std::uint32_t> positions;
        for (const std::uint32_t vertex : mesh().indices) positions.push_back(mesh().vertexPositions[vertex]);
        return positions;
    }

    // "WC0301:7" for each thing said, in order.
    std::vector<std::string> said() const {
        std::vector<std::string> codes;
        for (const Diagnostic& d : diagnostics.all()) codes.push_back(d.code + ":" + std::to_string(d.line));
        return codes;
    }

    // The area of all triangles that face +Z, those that face -Z taken off.
    float areaTowardsZ() const {
        float area = 0.0f;
        const auto at = [&](std::size_t i) {
            return mesh().positions[mesh().vertexPositions[mesh().indices[i]]];
        };
        for (std::size_t i = 0; i + 2 < mesh().indices.size(); i += 3) {
            const glm::vec3 a = at(i + 1) - at(i), b = at(i + 2) - at(i);
            area += (a.x * b.y - a.y * b.x) * 0.5f;
        }
        return area;
    }

private:
    GeometryFixture(const std::string& xml, int) {
        DocumentSet documents(options, diagnostics);
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(xml.data());
        const ColladaDocument& collada = documents.openMemory(std::span(bytes, xml.size()), "test.dae");
        Dialects dialects(options, diagnostics);
        SourceReader sources(documents, diagnostics, dialects);
        const LoadContext context{options, diagnostics, documents, sources, dialects};
        loaded = loadGeometry(collada.byId("shape"), context);
    }

    static std::string document(const std::string& content) {
        return "<COLLADA version=\"1.4.1\" "
               "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\"><library_geometries>"
               "<geometry id=\"shape\">\n" +
               content + "</geometry></library_geometries></COLLADA>\n";
    }
};

// One line: a <source> of that many numbers per entry.
inline std::string source(const std::string& id, std::size_t width, const std::string& numbers) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        count += numbers[i] != ' ' && (i == 0 || numbers[i - 1] == ' ');
    return "<source id=\"" + id + "\"><float_array id=\"" + id + "-array\" count=\"" + std::to_string(count) +
           "\">" + numbers + "</float_array><technique_common><accessor source=\"#" + id +
           "-array\" count=\"" + std::to_string(count / width) + "\" stride=\"" + std::to_string(width) +
           "\"/></technique_common></source>\n";
}

// Lines 3 and 4 of the document: positions, and <vertices> with them and with `more` inputs.
inline std::string vertices(const std::string& positions, const std::string& more = "",
                            std::size_t width = 3) {
    return source("pos", width, positions) +
           "<vertices id=\"verts\"><input semantic=\"POSITION\" source=\"#pos\"/>" + more + "</vertices>\n";
}

inline std::string input(const std::string& semantic, const std::string& source, int offset,
                         const std::string& more = "") {
    return "<input semantic=\"" + semantic + "\" source=\"#" + source + "\" offset=\"" +
           std::to_string(offset) + "\" " + more + "/>\n";
}

// The unit square, counterclockwise seen from +Z.
inline const std::string kSquare = "0 0 0 1 0 0 1 1 0 0 1 0";

}  // namespace walkcycle
