#include "app/ModelFacts.h"

#include <algorithm>
#include <cstddef>

namespace walkcycle {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

MeshFacts factsOf(const MeshData& mesh) {
    MeshFacts facts{.name = mesh.id.empty() ? mesh.name : mesh.id,
                    .positions = mesh.positions.size(),
                    .vertices = mesh.vertexCount()};
    for (const MeshPart& part : mesh.parts) {
        if (part.primitive == Primitive::Triangles)
            facts.triangles += part.indexCount / 3;
        else
            facts.lines += part.indexCount / 2;
    }
    return facts;
}

std::size_t mostInfluences(const Influences& influences) {
    std::size_t most = 0;
    for (std::size_t p = 0; p + 1 < influences.first.size(); ++p)
        most = std::max<std::size_t>(most, influences.first[p + 1] - influences.first[p]);
    return most;
}

void addInstance(MeshFacts& facts, const Model& model, const MeshInstance& instance) {
    ++facts.instances;
    for (const Deformer& deformer : instance.deformers) {
        if (deformer.kind == Deformer::Kind::Morph) {
            facts.morphTargets =
                std::max(facts.morphTargets, model.morphs[at(deformer.index)].targets.size());
            continue;
        }
        // The skin's last entry is its own node, not a joint.
        facts.joints = std::max(facts.joints, model.skins[at(deformer.index)].joints.size() - 1);
        facts.maxInfluences =
            std::max(facts.maxInfluences, mostInfluences(model.influences[at(deformer.influences)]));
    }
}

ClipFacts factsOf(const Animation& clip) {
    ClipFacts facts{.name = clip.name,
                    .startSeconds = clip.startSeconds,
                    .endSeconds = clip.endSeconds,
                    .movingJoints = clip.channels.size(),
                    .movingParameters = clip.parameterTracks.size(),
                    .achievedError = static_cast<double>(clip.achievedError)};
    for (const Channel& channel : clip.channels)
        facts.keys += channel.keyFrames.size() + channel.matrixKeyFrames.size();
    for (const ParameterTrack& track : clip.parameterTracks) facts.keys += track.keyFrames.size();
    return facts;
}

}  // namespace

ModelFacts factsOf(const Model& model) {
    ModelFacts facts;
    for (const MeshData& mesh : model.meshes) facts.meshes.push_back(factsOf(mesh));
    for (const MeshInstance& instance : model.instances) {
        MeshFacts& mesh = facts.meshes[at(instance.mesh)];
        addInstance(mesh, model, instance);
        facts.drawnVertices += mesh.vertices;
        facts.drawnTriangles += mesh.triangles;
    }
    for (const MeshFacts& mesh : facts.meshes)
        facts.maxInfluences = std::max(facts.maxInfluences, mesh.maxInfluences);
    for (const Animation& clip : model.animations) facts.clips.push_back(factsOf(clip));
    for (const Joint& joint : model.skeleton.joints) facts.joints += joint.isJoint;
    return facts;
}

const char* nameOf(UpAxis axis) {
    return axis == UpAxis::X ? "X" : axis == UpAxis::Y ? "Y" : "Z";
}

const char* nameOf(ShadingModel shading) {
    switch (shading) {
        case ShadingModel::Constant:
            return "constant";
        case ShadingModel::Lambert:
            return "lambert";
        case ShadingModel::Phong:
            return "phong";
        case ShadingModel::Blinn:
            return "blinn";
    }
    return "";
}

const char* nameOf(LightKind kind) {
    switch (kind) {
        case LightKind::Ambient:
            return "ambient";
        case LightKind::Directional:
            return "directional";
        case LightKind::Point:
            return "point";
        case LightKind::Spot:
            return "spot";
    }
    return "";
}

}  // namespace walkcycle
