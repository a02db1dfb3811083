#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

#include "loaders/context/LoadContext.h"
#include "loaders/document/DocumentSet.h"
#include "loaders/quirks/Dialect.h"
#include "walkcycle/loaders/ColladaLoader.h"

// Small documents as text, and what loading them says: what the tests of this folder share.
namespace walkcycle {

// ---- making documents

std::string collada(const std::string& body);  // in metres, Y up
std::string scene(
    const std::string& nodes);  // the only <visual_scene>, "scene", and the <scene> that shows it

// Sources of as many entries as their text holds.
std::string floatSource(const std::string& id, const std::string& numbers, const std::string& params = "XYZ");
std::string matrixSource(const std::string& id, const std::string& numbers);
std::string nameSource(const std::string& id, const std::string& names,
                       const std::string& array = "Name_array");

// A <library_geometries> with one triangle; its positions are (0,0,0), (1,0,0) and (0,1,0) unless told.
std::string triangle(const std::string& id = "mesh", const std::string& positions = "0 0 0 1 0 0 0 1 0");

// A <controller> with a <skin> of `source`, to be changed piece by piece.
struct SkinText {
    std::string id = "skin", source = "#mesh";
    std::string bindShape{};  // the element, where there is one
    std::string joints = nameSource("joints", "hip knee");
    std::string inverseBinds{};  // a source "binds"; empty: no such input
    std::string weights = floatSource("weights", "1 0.5 0.25", "W");
    std::string weightInputs{};  // more <input>s of <vertex_weights>
    int positions = 3;           // the count that <vertex_weights> claims
    std::string vcount = "1 1 1";
    std::string v = "0 0 1 0 1 0";

    std::string text() const;
};

inline const std::string kIdentity = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 ";
std::string controllers(const std::string& body);  // <library_controllers> around it

// ---- loading them

Bytes bytesOf(std::string_view text);
inline Model loadText(std::string_view text, const LoadOptions& options = {}) {
    return loadCollada(bytesOf(text), "test.dae", options);
}
// The same for a document that cannot be loaded: why. A test failure where it can.
inline Diagnostic whyNot(std::string_view text, const LoadOptions& options = {}) {
    try {
        loadText(text, options);
    } catch (const LoadError& error) {
        if (!error.diagnostics.empty()) return error.diagnostics.back();
    }
    ADD_FAILURE() << "the document loads";
    return {};
}

// What the loaders of one load share, for tests of one loader alone.
class TestLoad {
public:
    explicit TestLoad(std::string_view text, LoadOptions loadOptions = {});

    LoadOptions options;
    Diagnostics diagnostics;
    DocumentSet documents;
    Dialects dialects;
    SourceReader sources;
    LoadContext context{options, diagnostics, documents, sources, dialects};
    XmlNode collada;

    XmlNode byId(std::string_view id) const { return collada.elementById(id); }
};

// Where an instance's positions stand at a time of the document, in metres and Y up unless the load converted nothing.
std::vector<glm::vec3> posed(const Model& model, double seconds = 0.0, std::size_t instance = 0);

MATCHER_P3(isAt, x, y, z, "") {
    *result_listener << "(" << arg.x << ", " << arg.y << ", " << arg.z << ")";
    return glm::length(arg - glm::vec3(x, y, z)) < 1e-5f;
}

// ---- looking at what was said

void PrintTo(const Diagnostic& diagnostic, std::ostream* out);  // in the words of failing tests

int lineOf(std::string_view text, std::string_view part);  // 1-based, where `part` stands first; 0: nowhere
std::vector<std::string> codes(const std::vector<Diagnostic>& diagnostics);

// EXPECT_THAT(model.diagnostics, Contains(says("WC0201", 12, "COLLADA/scene/instance_visual_scene")));
MATCHER_P3(says, code, line, path, "") {
    return arg.code == code && arg.line == line && arg.elementPath == path;
}

}  // namespace walkcycle
