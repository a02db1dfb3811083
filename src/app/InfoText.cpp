#include "app/InfoText.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "app/FormatNumber.h"
#include "app/ModelFacts.h"
#include "walkcycle/model/Bounds.h"

namespace walkcycle {
namespace {

std::string quoted(const std::string& text) {
    return "'" + text + "'";
}

std::string plural(std::size_t count, const std::string& one) {
    const bool hisses = one.ends_with('x') || one.ends_with("sh");
    return std::to_string(count) + " " +
           (count == 1                ? one
            : one.ends_with("vertex") ? "vertices"
                                      : one + (hisses ? "es" : "s"));
}

// The lines of `info`. Lines of the same heading follow each other, and only the first of them shows it.
class Page {
public:
    explicit Page(std::string title) : text_(std::move(title) + "\n") {}
    void add(const std::string& heading, const std::string& line) {
        const std::string shown = heading == last_ ? "" : heading;
        last_ = heading;
        text_ += "  " + shown + std::string(11 - std::min<std::size_t>(10, shown.size()), ' ') + line + "\n";
    }
    std::string take() { return std::move(text_); }

private:
    std::string text_, last_;
};

std::string meshLine(const MeshFacts& mesh) {
    std::string line = quoted(mesh.name) + ": " + plural(mesh.vertices, "vertex") + ", " +
                       plural(mesh.triangles, "triangle");
    if (mesh.lines > 0) line += ", " + plural(mesh.lines, "line");
    if (mesh.joints > 0)
        line += ", skinned to " + plural(mesh.joints, "joint") + ", at most " +
                std::to_string(mesh.maxInfluences) + " a vertex";
    if (mesh.morphTargets > 0) line += ", " + plural(mesh.morphTargets, "morph target");
    if (mesh.instances != 1) line += ", drawn " + plural(mesh.instances, "time");
    return line;
}

std::string clipLine(std::size_t number, const ClipFacts& clip) {
    std::string line = std::to_string(number) + " " + quoted(clip.name) + ": " +
                       formatFixed(clip.startSeconds, 3) + " to " + formatFixed(clip.endSeconds, 3) + " s, " +
                       plural(clip.movingJoints, "node") + " moving";
    if (clip.movingParameters > 0) line += " and " + plural(clip.movingParameters, "value");
    return line + ", " + plural(clip.keys, "key") + ", off by at most " +
           formatScientific(clip.achievedError) + " of the model's size";
}

std::string materialLine(const Model& model, const Material& material) {
    std::string line =
        quoted(material.id.empty() ? material.name : material.id) + ": " + nameOf(material.shading);
    const ColorOrTexture& diffuse = material.slot(Slot::Diffuse);
    if (diffuse.texture >= 0) {
        line += ", texture " + quoted(model.textures[static_cast<std::size_t>(diffuse.texture)].id);
    } else if (diffuse.present) {
        line += ", colour";
        for (const int channel : {0, 1, 2}) line += " " + formatFixed(diffuse.color[channel], 2);
    }
    if (material.transparent) line += ", transparent";
    return line + (material.doubleSided ? ", double-sided" : "");
}

std::string textureLine(const Texture& texture) {
    const std::string line = quoted(texture.uri) + ": ";
    if (texture.path.empty()) return line + "missing";
    if (!texture.image) return line + "cannot be used (" + texture.path + ")";
    return line + texture.path + ", " + std::to_string(texture.image->width) + " x " +
           std::to_string(texture.image->height);
}

std::string sizeLine(const Model& model) {
    const Bounds box = animatedBounds(model, nullptr, 1);
    if (box.empty()) return "nothing to draw";
    const glm::vec3 size = box.max - box.min;
    return formatFixed(size.x, 3) + " x " + formatFixed(size.y, 3) + " x " + formatFixed(size.z, 3) +
           " at rest (width, height, depth)";
}

std::string quirkLine(const QuirkInfo& quirk, const Dialect& dialect) {
    return std::string(quirk.name) + ": " + (dialect.follows(quirk.quirk) ? "on, " : "off, ") +
           dialect.why(quirk.quirk) + (dialect.isUsed(quirk.quirk) ? "; used in this file" : "");
}

void addDialect(const Dialect& dialect, Page& page) {
    const std::string exporter = exporterText(dialect.exporter());
    page.add("dialect", exporter.empty() ? "of an unknown exporter" : exporter);
    for (const QuirkInfo& quirk : kQuirks) page.add("quirks", quirkLine(quirk, dialect));
}

}  // namespace

std::string exporterText(const Exporter& exporter) {
    if (exporter.tool == Tool::Unknown) return {};
    return std::string(nameOf(exporter.tool)) + (exporter.version ? " " + textOf(*exporter.version) : "");
}

std::string infoText(const Model& model, const Dialect* dialect) {
    const ModelFacts facts = factsOf(model);
    Page page(model.file);
    page.add("format", "COLLADA " + model.asset.version);
    page.add("made by", model.asset.authoringTool.empty() ? "(unknown)" : model.asset.authoringTool);
    if (dialect) addDialect(*dialect, page);
    page.add("axes", std::string(nameOf(model.asset.upAxis)) + " up");
    page.add("unit", quoted(model.asset.unitName) + ", " + formatNumber(model.asset.metersPerUnit) + " m");
    page.add("scene", quoted(model.sceneId) + ": " + plural(model.skeleton.joints.size(), "node") + ", " +
                          plural(facts.joints, "joint") + ", " +
                          plural(model.instances.size(), "drawn mesh"));
    page.add("size", sizeLine(model));
    for (const MeshFacts& mesh : facts.meshes) page.add("meshes", meshLine(mesh));
    for (std::size_t i = 0; i < facts.clips.size(); ++i) page.add("clips", clipLine(i, facts.clips[i]));
    if (facts.clips.empty()) page.add("clips", "none: nothing moves");
    for (const Material& material : model.materials) page.add("materials", materialLine(model, material));
    for (const Texture& texture : model.textures) page.add("textures", textureLine(texture));
    for (const CameraInstance& instance : model.cameraInstances) {
        const SceneCamera& camera = model.cameras[static_cast<std::size_t>(instance.camera)];
        page.add("cameras", quoted(model.skeleton.joints[static_cast<std::size_t>(instance.node)].id) + ": " +
                                quoted(camera.id) +
                                (camera.orthographic ? ", orthographic" : ", perspective"));
    }
    for (const LightInstance& instance : model.lightInstances) {
        const SceneLight& light = model.lights[static_cast<std::size_t>(instance.light)];
        page.add("lights", quoted(model.skeleton.joints[static_cast<std::size_t>(instance.node)].id) + ": " +
                               nameOf(light.kind));
    }
    return page.take();
}

}  // namespace walkcycle
