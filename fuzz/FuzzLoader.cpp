// Any bytes as a document. Whatever comes out of the loader must keep what its headers promise, at any time of any clip.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "Require.h"
#include "walkcycle/animation/Animator.h"
#include "walkcycle/loaders/ColladaLoader.h"
#include "walkcycle/model/Bounds.h"
#include "walkcycle/model/CpuSkinning.h"

namespace {

using namespace walkcycle;

// A document that may refer to others; they are made of the same bytes.
LoadOptions smallLoad(std::span<const std::uint8_t> bytes) {
    LoadOptions options;
    options.limits.maxNodes = 2000;
    options.limits.maxInstances = 500;
    options.limits.maxVertices = 200'000;
    options.limits.maxSkinJoints = 20'000;
    options.limits.maxKeyFrames = 50'000;
    options.limits.maxDocuments = 3;
    options.limits.maxImageDimension = 512;
    options.limits.maxImagePixels = 1 << 16;
    options.limits.maxArchiveBytes = 1 << 22;
    options.limits.maxArchiveEntries = 100;
    options.limits.maxPositions = 200'000;
    options.limits.maxInstancedElements = 20'000;
    options.limits.maxKeyNumbers = 500'000;
    options.resolver = [bytes](const std::string& path) -> std::optional<Bytes> {
        if (path.find("other") == std::string::npos) return std::nullopt;
        return Bytes(bytes.begin(), bytes.end());
    };
    return options;
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <typename T>
bool below(int index, const std::vector<T>& list) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
}

void checkMesh(const MeshData& mesh) {
    const std::size_t vertices = mesh.vertexCount();
    for (const glm::vec3& position : mesh.positions) REQUIRE(isFinite(position));
    REQUIRE(mesh.positionUsed.size() == mesh.positions.size());
    REQUIRE(mesh.normals.size() == vertices);
    for (const glm::vec3& normal : mesh.normals) REQUIRE(isFinite(normal));
    for (const std::uint32_t position : mesh.vertexPositions) REQUIRE(position < mesh.positions.size());
    for (const TexCoordSet& set : mesh.texCoordSets) REQUIRE(set.coords.size() == vertices);
    REQUIRE(mesh.colors.empty() || mesh.colors.size() == vertices);
    REQUIRE(mesh.tangents.empty() || mesh.tangents.size() == vertices);
    for (const std::uint32_t index : mesh.indices) REQUIRE(index < vertices);
    for (const MeshPart& part : mesh.parts)
        REQUIRE(std::uint64_t{part.firstIndex} + part.indexCount <= mesh.indices.size());
}

void checkSkin(const Model& model, const MeshInstance& instance, const Deformer& deformer) {
    REQUIRE(below(deformer.index, model.skins));
    REQUIRE(below(deformer.influences, model.influences));
    const Skin& skin = model.skins[static_cast<std::size_t>(deformer.index)];
    const Influences& all = model.influences[static_cast<std::size_t>(deformer.influences)];
    REQUIRE(skin.joints.size() == skin.bindMatrices.size());
    for (const int joint : skin.joints) REQUIRE(below(joint, model.skeleton.joints));
    REQUIRE(all.first.size() == model.meshes[static_cast<std::size_t>(instance.mesh)].positions.size() + 1);
    REQUIRE(std::is_sorted(all.first.begin(), all.first.end()) && all.first.front() == 0 &&
            all.first.back() == all.influences.size());
    for (const Influence& influence : all.influences)
        REQUIRE(influence.joint < skin.joints.size() && std::isfinite(influence.weight));
}

void checkInstance(const Model& model, const MeshInstance& instance) {
    REQUIRE(below(instance.node, model.skeleton.joints));
    REQUIRE(below(instance.mesh, model.meshes));
    REQUIRE(instance.materials.size() == model.meshes[static_cast<std::size_t>(instance.mesh)].parts.size());
    for (const PartMaterial& part : instance.materials)
        REQUIRE(part.material == -1 || below(part.material, model.materials));
    for (const Deformer& deformer : instance.deformers) {
        if (deformer.kind == Deformer::Kind::Skin)
            checkSkin(model, instance, deformer);
        else
            REQUIRE(below(deformer.index, model.morphs));
    }
}

void checkAnimation(const Model& model, const Animation& animation) {
    REQUIRE(std::isfinite(animation.startSeconds) && std::isfinite(animation.endSeconds));
    for (const Channel& channel : animation.channels) {
        REQUIRE(below(channel.joint, model.skeleton.joints));
        REQUIRE(channel.keyFrames.empty() != channel.matrixKeyFrames.empty());
        REQUIRE(channel.tangents.empty() || channel.tangents.size() == channel.keyFrames.size());
    }
    for (const ParameterTrack& track : animation.parameterTracks) {
        REQUIRE(below(track.parameter, model.parameters));
        REQUIRE(!track.keyFrames.empty());
    }
}

void play(const Model& model) {
    const std::vector<float> rest = model.restParameters();
    Animator animator(model.skeleton, rest);
    CpuSkinning skinning;
    std::vector<glm::vec3> positions, normals;
    for (const Animation& animation : model.animations) {
        checkAnimation(model, animation);
        animator.doAnimation(animation);
        for (const double share : {0.0, 0.37, 1.0}) {
            animator.sampleAt(animation.startSeconds + share * animation.lengthInSeconds());
            animator.update(1e9);
        }
    }
    for (const MeshInstance& instance : model.instances)
        skinning.vertices(model, instance, animator.modelTransforms(), animator.parameters(), positions,
                          normals);
    animatedBounds(model, model.animations.empty() ? nullptr : &model.animations.front(), 2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::uint8_t> bytes(data, size);
    try {
        const Model model = loadCollada(bytes, "fuzz.dae", smallLoad(bytes));
        for (const MeshData& mesh : model.meshes) checkMesh(mesh);
        for (const MeshInstance& instance : model.instances) checkInstance(model, instance);
        play(model);
    } catch (const LoadError& error) {
        REQUIRE(!error.diagnostics.empty());
        REQUIRE(error.diagnostics.back().severity == Severity::Error);
    }
    return 0;
}
