#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "render/AnimatedModelShader.h"
#include "render/JointPalette.h"
#include "render/ModelResource.h"
#include "render/ScreenArea.h"
#include "walkcycle/model/CpuSkinning.h"
#include "walkcycle/render/AnimatedModel.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {

// How each instance of a model is deformed at one moment: palettes, morph coefficients and, for instances
// that the shader cannot deform, vertices deformed on the CPU. Keeps its memory, so that pictures after the
// first allocate nothing.
class InstanceStates {
public:
    struct State {
        bool visible = true;  // if false, the rest is not computed
        JointPalette::Range palette;
        DeformUniforms::Values deform;
    };

    // Computes the states of all instances for the model's present pose, and uploads them.
    void prepare(const AnimatedModel& model);
    const std::vector<State>& states() const { return states_; }

    // Binds the textures that the shader reads for an instance, and returns the values of its uniforms.
    const DeformUniforms::Values& bind(const AnimatedModel& model, std::size_t instance) const;

    // The part of the picture that the instances can cover; the whole picture if an instance has no boxes (see
    // ModelResource::Instance).
    ScreenArea area(const AnimatedModel& model, const Camera& camera, const RenderTarget& target) const;

    // One of the instance's positions (an index into MeshData::positions), moved to model space by the instance's
    // skin or node, but not by its morphs. For sorting parts by their distance.
    glm::vec3 position(const AnimatedModel& model, std::size_t instance, std::uint32_t position) const;

private:
    void prepareInstance(const AnimatedModel& model, std::size_t instance);
    void addPalette(const AnimatedModel& model, std::size_t instance);
    void deformOnCpu(const AnimatedModel& model, std::size_t instance);
    void addMorphs(const AnimatedModel& model, std::size_t instance);

    JointPalette palette_;
    BufferTexture morphTexture_{GL_RG32F};
    std::vector<State> states_;
    std::vector<float> coefficients_;
    std::vector<glm::vec2> morphs_;
    CpuSkinning cpu_;
    std::vector<glm::vec3> positions_, normals_;
};

}  // namespace walkcycle
