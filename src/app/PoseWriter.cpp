#include "app/PoseWriter.h"

#include <cstddef>
#include <vector>

#include "animation/RowMajor.h"
#include "app/JointKeys.h"
#include "app/JsonText.h"

namespace walkcycle {
namespace {

// Writes a list: calls write(i) for each i below `count`, with commas between.
template <typename Write>
void list(JsonText& json, std::size_t count, Write write) {
    json.raw("[");
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) json.raw(",");
        write(i);
    }
    json.raw("]");
}

void member(JsonText& json, std::string_view name, std::string_view value) {
    json.string(name);
    json.raw(":");
    json.string(value);
    json.raw(",");
}

template <typename Number>
void rowMajor(JsonText& json, const glm::mat<4, 4, Number>& matrix) {
    const auto rows = rowsOf(matrix);
    list(json, rows.size(), [&](std::size_t i) { json.number(rows[i]); });
}

// Writes the positions that a surface uses. Positions that only lines use, or nothing, are left out.
template <typename Number>
void usedPositions(JsonText& json, const MeshData& mesh, const std::vector<glm::vec<3, Number>>& positions) {
    json.raw("[");
    bool first = true;
    for (std::size_t p = 0; p < positions.size(); ++p) {
        if (!mesh.positionUsed[p]) continue;
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            if (!first) json.raw(",");
            first = false;
            json.number(positions[p][axis]);
        }
    }
    json.raw("]");
}

}  // namespace

template <typename Number>
std::string poseJson(const Model& model, std::span<const double> times,
                     std::span<const PosedModel<Number>> poses) {
    const std::vector<std::string> keys = jointKeys(model.skeleton);
    JsonText json;
    json.raw("{");
    member(json, "file", model.file);
    json.raw("\"times\":");
    list(json, times.size(), [&](std::size_t t) { json.number(times[t]); });
    json.raw(",\n\"joints\":{");
    for (std::size_t j = 0; j < keys.size(); ++j) {
        json.raw(j == 0 ? "\n" : ",\n");
        json.string(keys[j]);
        json.raw(":{");
        member(json, "name", model.skeleton.joints[j].name);
        member(json, "sid", model.skeleton.joints[j].sid);
        json.raw("\"world\":");
        list(json, poses.size(), [&](std::size_t t) { rowMajor(json, poses[t].joints[j]); });
        json.raw("}");
    }
    json.raw("},\n\"instances\":");
    list(json, model.instances.size(), [&](std::size_t i) {
        const MeshInstance& instance = model.instances[i];
        const MeshData& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
        json.raw("\n{");
        member(json, "node", keys[static_cast<std::size_t>(instance.node)]);
        member(json, "geometry", mesh.id);
        member(json, "source", instance.sourceUrl);
        json.raw("\"positions\":");
        list(json, poses.size(), [&](std::size_t t) { usedPositions(json, mesh, poses[t].positions[i]); });
        json.raw("}");
    });
    json.raw("}\n");
    return json.take();
}

template std::string poseJson(const Model&, std::span<const double>, std::span<const PosedModel<float>>);
template std::string poseJson(const Model&, std::span<const double>, std::span<const PosedModel<double>>);

}  // namespace walkcycle
