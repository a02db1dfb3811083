#include "loaders/LoadText.h"

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <utility>

#include "loaders/text/Words.h"
#include "walkcycle/animation/Animator.h"
#include "walkcycle/model/CpuSkinning.h"

namespace walkcycle {
namespace {

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string source(const std::string& id, const std::string& array, const std::string& words,
                   std::size_t stride, const std::string& params) {
    const std::size_t count = splitWords(words).size();
    return "<source" + attribute("id", id) + ">\n<" + array + attribute("id", id + "-array") +
           attribute("count", std::to_string(count)) + ">" + words + "</" + array +
           ">\n<technique_common><accessor" + attribute("source", "#" + id + "-array") +
           attribute("count", std::to_string(count / stride)) + attribute("stride", std::to_string(stride)) +
           ">" + params + "</accessor></technique_common>\n</source>\n";
}

std::string input(const char* semantic, const std::string& id, int offset = -1) {
    return std::string("<input") + attribute("semantic", semantic) + attribute("source", "#" + id) +
           (offset < 0 ? "" : attribute("offset", std::to_string(offset))) + "/>\n";
}

}  // namespace

std::string collada(const std::string& body) {
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
           "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\n"
           "<asset><unit name=\"meter\" meter=\"1\"/><up_axis>Y_UP</up_axis></asset>\n" +
           body + "</COLLADA>\n";
}

std::string scene(const std::string& nodes) {
    return "<library_visual_scenes><visual_scene id=\"scene\">\n" + nodes +
           "\n</visual_scene></library_visual_scenes>\n<scene><instance_visual_scene "
           "url=\"#scene\"/></scene>\n";
}

std::string floatSource(const std::string& id, const std::string& numbers, const std::string& params) {
    std::string elements;
    for (const char name : params)
        elements += "<param" + attribute("name", {name}) + attribute("type", "float") + "/>";
    return source(id, "float_array", numbers, params.size(), elements);
}

std::string matrixSource(const std::string& id, const std::string& numbers) {
    return source(id, "float_array", numbers, 16, "<param name=\"TRANSFORM\" type=\"float4x4\"/>");
}

std::string nameSource(const std::string& id, const std::string& names, const std::string& array) {
    return source(id, array, names, 1, "<param name=\"JOINT\" type=\"name\"/>");
}

std::string triangle(const std::string& id, const std::string& positions) {
    return "<library_geometries><geometry" + attribute("id", id) + "><mesh>\n" +
           floatSource(id + "-positions", positions) + "<vertices" + attribute("id", id + "-vertices") + ">" +
           input("POSITION", id + "-positions") + "</vertices>\n<triangles count=\"1\">" +
           input("VERTEX", id + "-vertices", 0) +
           "<p>0 1 2</p></triangles>\n</mesh></geometry></library_geometries>\n";
}

std::string controllers(const std::string& body) {
    return "<library_controllers>\n" + body + "</library_controllers>\n";
}

std::string SkinText::text() const {
    std::string text =
        "<controller" + attribute("id", id) + "><skin" + attribute("source", source) + ">\n" + bindShape;
    text += joints + inverseBinds + weights + "<joints>\n" + input("JOINT", "joints");
    if (!inverseBinds.empty()) text += input("INV_BIND_MATRIX", "binds");
    text += "</joints>\n<vertex_weights" + attribute("count", std::to_string(positions)) + ">\n";
    text += input("JOINT", "joints", 0) + input("WEIGHT", "weights", 1) + weightInputs;
    text += "<vcount>" + vcount + "</vcount>\n<v>" + v + "</v>\n</vertex_weights>\n</skin></controller>\n";
    return text;
}

Bytes bytesOf(std::string_view text) {
    return {text.begin(), text.end()};
}

TestLoad::TestLoad(std::string_view text, LoadOptions loadOptions)
    : options(std::move(loadOptions)),
      documents(options, diagnostics),
      dialects(options, diagnostics),
      sources(documents, diagnostics, dialects) {
    collada = documents.openMemory(bytesOf(text), "test.dae").root();
}

std::vector<glm::vec3> posed(const Model& model, double seconds, std::size_t instance) {
    const std::vector<float> rest = model.restParameters();
    Animator animator(model.skeleton, rest);
    if (!model.animations.empty()) {
        animator.doAnimation(model.animations[0]);
        animator.sampleAt(seconds);
    }
    std::vector<glm::vec3> positions;
    CpuSkinning().positions(model, model.instances.at(instance), animator.modelTransforms(),
                            animator.parameters(), positions);
    return positions;
}

void PrintTo(const Diagnostic& diagnostic, std::ostream* out) {
    *out << toString(diagnostic) << " at " << diagnostic.elementPath;
}

int lineOf(std::string_view text, std::string_view part) {
    const std::size_t at = text.find(part);
    if (at == std::string_view::npos) return 0;
    return 1 +
           static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

std::vector<std::string> codes(const std::vector<Diagnostic>& diagnostics) {
    std::vector<std::string> all;
    for (const Diagnostic& diagnostic : diagnostics) all.push_back(diagnostic.code);
    return all;
}

}  // namespace walkcycle
