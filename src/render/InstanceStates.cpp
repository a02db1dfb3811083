#include "render/InstanceStates.h"

#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/geometric.hpp>

#include "model/Deformers.h"
#include "render/VertexInput.h"
#include "walkcycle/animation/Skin.h"

namespace walkcycle {
namespace {

constexpr std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

glm::vec3 transformed(const JointRows& joint, const glm::vec4& point) {
    return {glm::dot(joint.rows[0], point), glm::dot(joint.rows[1], point), glm::dot(joint.rows[2], point)};
}

}  // namespace

void InstanceStates::prepare(const AnimatedModel& model) {
    palette_.clear();
    morphs_.clear();
    states_.assign(model.model().instances.size(), {});
    for (std::size_t i = 0; i < states_.size(); ++i) prepareInstance(model, i);
    palette_.upload();
    if (!morphs_.empty()) morphTexture_.store(std::span<const glm::vec2>(morphs_), GL_STREAM_DRAW);
}

void InstanceStates::prepareInstance(const AnimatedModel& model, std::size_t i) {
    const MeshInstance& instance = model.model().instances[i];
    const MeshData& mesh = model.model().meshes[index(instance.mesh)];
    State& state = states_[i];
    state.visible = model.visible(instance.node);
    if (!state.visible) return;
    state.deform.positionCount = static_cast<int>(mesh.positions.size());
    state.deform.vertexCount = static_cast<int>(mesh.vertexCount());
    addPalette(model, i);
    const ModelResource::Instance& resource = model.resource()->instances()[i];
    if (resource.influenceBuffers) state.deform.influenceCount = resource.influenceBuffers->count;
    if (resource.deformedOnCpu) deformOnCpu(model, i);
    if (resource.morphCount > 0) addMorphs(model, i);
}

// A mesh without a skin has a palette of one matrix: its node's model transform; or the identity if its vertices were
// deformed on the CPU, because these are in model space already.
void InstanceStates::addPalette(const AnimatedModel& model, std::size_t i) {
    const ModelResource::Instance& resource = model.resource()->instances()[i];
    const auto& transforms = model.animator().modelTransforms();
    const Skin* skin = resource.skin >= 0 ? &model.model().skins[index(resource.skin)] : nullptr;
    State& state = states_[i];
    state.palette = palette_.add(skin ? skin->joints.size() : 1);
    state.deform.firstJoint = static_cast<int>(state.palette.firstJoint);
    const std::span<JointRows> palette = palette_.joints(state.palette);
    if (skin)
        computePalette(*skin, transforms, palette);
    else if (resource.deformedOnCpu)
        palette[0] = JointRows();
    else
        palette[0] = JointRows(transforms[index(model.model().instances[i].node)]);
}

void InstanceStates::deformOnCpu(const AnimatedModel& model, std::size_t i) {
    cpu_.vertices(model.model(), model.model().instances[i], model.animator().modelTransforms(),
                  model.animator().parameters(), positions_, normals_);
    DeformedBuffers& buffers = *model.resource()->instances()[i].deformed;
    buffers.positions.store(std::span<const glm::vec3>(positions_), GL_STREAM_DRAW);
    buffers.normals.store(std::span<const glm::vec3>(normals_), GL_STREAM_DRAW);
}

// Adds only the targets whose coefficient is not 0 at this moment: most are 0.
void InstanceStates::addMorphs(const AnimatedModel& model, std::size_t i) {
    const ModelResource::Instance& resource = model.resource()->instances()[i];
    const auto morphs = std::span(model.model().instances[i].deformers).first(resource.morphCount);
    morphCoefficients(model.model(), morphs, model.animator().parameters(), coefficients_);
    glm::ivec2& range = states_[i].deform.morphRange;
    range.x = static_cast<int>(morphs_.size());
    for (std::size_t t = 0; t < coefficients_.size(); ++t) {
        if (coefficients_[t] != 0.0f) morphs_.emplace_back(static_cast<float>(t), coefficients_[t]);
    }
    range.y = static_cast<int>(morphs_.size());
}

const DeformUniforms::Values& InstanceStates::bind(const AnimatedModel& model, std::size_t i) const {
    const ModelResource::Instance& resource = model.resource()->instances()[i];
    palette_.bind(states_[i].palette.page, TextureUnit::kPalette);
    if (resource.influenceBuffers && resource.influenceBuffers->more) {
        resource.influenceBuffers->more->bind(TextureUnit::kMoreInfluences);
    }
    if (resource.morphBuffers) {
        morphTexture_.bind(TextureUnit::kMorphs);
        resource.morphBuffers->positionDeltas.bind(TextureUnit::kPositionDeltas);
        resource.morphBuffers->normalDeltas.bind(TextureUnit::kNormalDeltas);
    }
    // Values of the vertex shader's inputs that have no buffer: all weight is on joint 0, the colour is white.
    glVertexAttribI4ui(VertexInput::kJointIndices, 0, 0, 0, 0);
    glVertexAttrib4f(VertexInput::kWeights, 1.0f, 0.0f, 0.0f, 0.0f);
    glVertexAttribI4ui(VertexInput::kMoreInfluences, 0, 0, 0, 0);
    glVertexAttrib4f(VertexInput::kNormal, 0.0f, 0.0f, 0.0f, 0.0f);
    glVertexAttrib4f(VertexInput::kColor, 1.0f, 1.0f, 1.0f, 1.0f);
    glVertexAttrib4f(VertexInput::kTangent, 0.0f, 0.0f, 0.0f, 1.0f);
    for (int s = 0; s < kSlotCount; ++s) {
        glVertexAttrib4f(VertexInput::kTextureCoords + static_cast<GLuint>(s), 0.0f, 0.0f, 0.0f, 1.0f);
    }
    return states_[i].deform;
}

ScreenArea InstanceStates::area(const AnimatedModel& model, const Camera& camera,
                                const RenderTarget& target) const {
    ScreenArea area = ScreenArea::none(target.width, target.height);
    for (std::size_t i = 0; i < states_.size(); ++i) {
        const std::vector<Bounds>& boxes = model.resource()->instances()[i].boxes;
        if (!states_[i].visible) continue;
        const std::span<const JointRows> palette = palette_.joints(states_[i].palette);
        if (boxes.size() != palette.size()) return ScreenArea::whole();
        for (std::size_t m = 0; m < boxes.size(); ++m)
            area.add(boxes[m], camera.viewProjection() * palette[m].toMatrix());
    }
    return area;
}

glm::vec3 InstanceStates::position(const AnimatedModel& model, std::size_t i, std::uint32_t position) const {
    const MeshInstance& instance = model.model().instances[i];
    const ModelResource::Instance& resource = model.resource()->instances()[i];
    const glm::vec4 point(model.model().meshes[index(instance.mesh)].positions[position], 1.0f);
    if (resource.skin < 0) {
        return glm::vec3(model.animator().modelTransforms()[index(instance.node)] * point);
    }
    const Influences& influences = model.model().influences[index(resource.influences)];
    const std::span<const JointRows> palette = palette_.joints(states_[i].palette);
    glm::vec3 sum(0.0f);
    for (std::uint32_t k = influences.first[position]; k < influences.first[position + 1]; ++k) {
        const Influence& influence = influences.influences[k];
        sum += transformed(palette[influence.joint], point) * influence.weight;
    }
    return sum;
}

}  // namespace walkcycle
