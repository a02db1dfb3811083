#include "render/AnimatedModelShader.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "render/Srgb.h"
#include "render/VertexInput.h"

namespace walkcycle {
namespace {

constexpr std::uint32_t bit(Slot slot) {
    return 1u << static_cast<unsigned>(slot);
}
// The slots that studioFragment.glsl reads.
constexpr std::uint32_t kStudioSlots =
    bit(Slot::Emission) | bit(Slot::Diffuse) | bit(Slot::Transparent) | bit(Slot::Bump);

// Those of the needs that the shader of this kind of light can meet.
ShaderNeeds usedNeeds(ShaderNeeds needs, Lighting lighting) {
    if (lighting == Lighting::Studio) needs.texturedSlots &= kStudioSlots;
    needs.bumped = needs.bumped && (needs.texturedSlots & bit(Slot::Bump));
    return needs;
}

std::string defines(const AnimatedModelShader::Variant& variant) {
    const ShaderNeeds& needs = variant.needs;
    std::string text = deformDefines(needs);
    text += "#define TEXTURED " + std::to_string(needs.texturedSlots & ~bit(Slot::Bump)) + "\n";
    const auto define = [&](bool wanted, const char* name) {
        if (wanted) text += std::string("#define ") + name + "\n";
    };
    define(needs.separateCoords, "SEPARATE_COORDS");
    define(needs.bumped, "BUMP");
    define(needs.vertexColors, "VERTEX_COLORS");
    define(needs.seeThrough, "SEE_THROUGH");
    define(variant.encodesItself, "ENCODES_ITSELF");
    return text;
}

ShaderProgram program(const AnimatedModelShader::Variant& variant) {
    if (variant.lighting == Lighting::Studio) {
        return ShaderProgram({{"animatedModelVertex"}, {"surface", "studioFragment"}}, defines(variant));
    }
    return ShaderProgram({{"animatedModelVertex"}, {"surface", "fileFragment"}}, defines(variant));
}

// The diffuse colour of a material that has neither a diffuse nor an emission colour, in sRGB. For studio light only:
// by the formulas of COLLADA such a material is black.
constexpr glm::vec4 kClay{0.75f, 0.75f, 0.75f, 1.0f};

std::array<glm::vec4, kSlotCount> slotColors(const Material& material, Lighting lighting) {
    std::array<glm::vec4, kSlotCount> colors;
    for (std::size_t s = 0; s < colors.size(); ++s) colors[s] = material.slots[s].color;
    const bool hasNoColor = !material.slot(Slot::Diffuse).present && !material.slot(Slot::Emission).present;
    if (lighting == Lighting::File) return colors;
    if (hasNoColor) colors[static_cast<std::size_t>(Slot::Diffuse)] = kClay;
    for (const Slot slot : {Slot::Diffuse, Slot::Emission}) {
        glm::vec4& color = colors[static_cast<std::size_t>(slot)];
        color = glm::vec4(linearOfSrgb(glm::vec3(color)), color.a);
    }
    return colors;
}

}  // namespace

std::string deformDefines(const ShaderNeeds& needs) {
    return std::string(needs.morphs ? "#define MORPHS\n" : "") +
           (needs.moreInfluences ? "#define MORE_INFLUENCES\n" : "");
}

DeformUniforms::DeformUniforms(const ShaderProgram& program)
    : firstJoint_(program.uniform("firstJoint")),
      jointsPerWalker_(program.uniform("jointsPerWalker")),
      influenceCount_(program.uniform("influenceCount")),
      morphRange_(program.uniform("morphRange")),
      positionCount_(program.uniform("positionCount")),
      vertexCount_(program.uniform("vertexCount")) {
    program.setSampler("palette", TextureUnit::kPalette);
    program.setSampler("moreInfluences", TextureUnit::kMoreInfluences);
    program.setSampler("morphs", TextureUnit::kMorphs);
    program.setSampler("positionDeltas", TextureUnit::kPositionDeltas);
    program.setSampler("normalDeltas", TextureUnit::kNormalDeltas);
}

void DeformUniforms::load(const Values& values) const {
    glUniform1i(firstJoint_, values.firstJoint);
    glUniform1i(jointsPerWalker_, values.jointsPerWalker);
    glUniform1i(influenceCount_, values.influenceCount);
    glUniform2i(morphRange_, values.morphRange.x, values.morphRange.y);
    glUniform1i(positionCount_, values.positionCount);
    glUniform1i(vertexCount_, values.vertexCount);
}

AnimatedModelShader::AnimatedModelShader(const Variant& variant)
    : variant_{variant.lighting, variant.encodesItself, usedNeeds(variant.needs, variant.lighting)},
      program_(walkcycle::program(variant_)),
      deform_((program_.start(), program_)),
      viewProjection_(program_.uniform("viewProjection")),
      eye_(program_.uniform("eye")),
      slotColors_(program_.uniform("slotColors")),
      opaqueMode_(program_.uniform("opaqueMode")),
      transparency_(program_.uniform("transparency")),
      pass_(program_.uniform("pass")),
      bumped_(program_.uniform("bumped")),
      keyDirection_(program_.uniform("keyDirection")),
      fillDirection_(program_.uniform("fillDirection")),
      rimDirection_(program_.uniform("rimDirection")),
      shadingModel_(program_.uniform("shadingModel")),
      shininess_(program_.uniform("shininess")),
      reflectivity_(program_.uniform("reflectivity")),
      ambientLight_(program_.uniform("ambientLight")),
      lightCount_(program_.uniform("lightCount")) {
    std::array<GLint, kSlotCount> units;
    for (std::size_t s = 0; s < units.size(); ++s) units[s] = static_cast<GLint>(s);
    glUniform1iv(program_.uniform("slotTextures"), kSlotCount, units.data());
    program_.setSampler("bumpTexture", static_cast<int>(Slot::Bump));
    program_.setSampler("lights", TextureUnit::kLights);
}

void AnimatedModelShader::loadCamera(const Camera& camera) const {
    setUniform(viewProjection_, camera.viewProjection());
    setUniform(eye_, camera.orthographic ? glm::vec4(-camera.direction(), 0.0f)
                                         : glm::vec4(camera.position(), 1.0f));
    // The lamps stand around the camera and move with it.
    const glm::mat3 fromView = glm::transpose(glm::mat3(camera.view));
    setUniform(keyDirection_, fromView * glm::normalize(glm::vec3(-0.55f, 0.75f, 0.75f)));
    setUniform(fillDirection_, fromView * glm::normalize(glm::vec3(0.9f, 0.15f, 0.6f)));
    setUniform(rimDirection_, fromView * glm::normalize(glm::vec3(0.35f, 0.6f, -0.9f)));
}

void AnimatedModelShader::loadLights(const FileLights& lights) const {
    setUniform(ambientLight_, lights.ambient());
    setUniform(lightCount_, lights.count());
}

void AnimatedModelShader::loadMaterial(const Material& material, const ModelResource& resource) const {
    const auto colors = slotColors(material, variant_.lighting);
    glUniform4fv(slotColors_, kSlotCount, &colors[0].x);
    setUniform(opaqueMode_, material.transparent ? static_cast<int>(material.opaque) : -1);
    setUniform(transparency_, material.transparency);
    setUniform(shadingModel_, static_cast<int>(material.shading));
    setUniform(shininess_, material.shininess);
    setUniform(reflectivity_, material.reflectivity);
    for (int s = 0; s < kSlotCount; ++s) {
        if (!(variant_.needs.texturedSlots & (1u << s))) continue;
        const auto slot = static_cast<Slot>(s);
        const GlTexture* texture = resource.texture(material.slot(slot).texture, slot);
        (texture ? *texture : resource.white()).bind(s);
        if (slot == Slot::Bump) setUniform(bumped_, texture ? 1 : 0);
    }
}

void AnimatedModelShader::loadPass(Pass pass) const {
    constexpr std::array<glm::ivec2, 4> values{{{0, 0}, {1, 0}, {2, -1}, {2, 1}}};
    const glm::ivec2 value = values[static_cast<std::size_t>(pass)];
    glUniform2i(pass_, value.x, value.y);
}

}  // namespace walkcycle
