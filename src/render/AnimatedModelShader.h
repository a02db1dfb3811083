#pragma once

#include <compare>
#include <string>

#include <glm/vec2.hpp>

#include "render/FileLights.h"
#include "render/ModelResource.h"
#include "render/ShaderProgram.h"
#include "walkcycle/model/Material.h"
#include "walkcycle/render/Camera.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {

// The uniforms of animatedModelVertex.glsl that say how an instance is deformed. They have the same names there.
struct DeformUniforms {
    struct Values {
        int firstJoint = 0;           // index of the instance's first matrix in the palette
        int jointsPerWalker = 0;      // in a crowd: how many matrices later the next walker's palette begins
        int influenceCount = 1;       // the most influences of a vertex, up to four
        glm::ivec2 morphRange{0, 0};  // [first, end) in `morphs`
        int positionCount = 0;        // of the mesh: deltas per morph target in `positionDeltas`
        int vertexCount = 0;          // of the mesh: deltas per morph target in `normalDeltas`
    };

    explicit DeformUniforms(const ShaderProgram& program);  // the program must be started
    void load(const Values& values) const;

private:
    GLint firstJoint_, jointsPerWalker_, influenceCount_, morphRange_, positionCount_, vertexCount_;
};

// The #defines of animatedModelVertex.glsl for what a model needs.
std::string deformDefines(const ShaderNeeds& needs);

// The shader program that draws a model: skinning and morphs in the vertex shader, the light of RenderOptions::lights
// in the fragment shader. It is compiled for the needs of all parts of a model, so that one variant draws the whole
// model. Call start() before the load functions, which set uniforms and bind textures.
class AnimatedModelShader {
public:
    struct Variant {
        Lighting lighting = Lighting::Studio;
        bool encodesItself = false;  // the shader converts light to sRGB, because the target does not
        ShaderNeeds needs;

        auto operator<=>(const Variant&) const = default;
    };
    // The fragments that a draw keeps: all, only opaque ones, or only transparent ones of back or of front faces. (Back
    // faces are drawn before front faces, which blend with them.)
    enum class Pass { All, Solid, Backs, Fronts };

    explicit AnimatedModelShader(const Variant& variant);

    void start() const { program_.start(); }
    void loadCamera(const Camera& camera) const;
    void loadLights(const FileLights& lights) const;
    void loadInstance(const DeformUniforms::Values& values) const { deform_.load(values); }
    void loadMaterial(const Material& material, const ModelResource& resource) const;
    void loadPass(Pass pass) const;

private:
    Variant variant_;
    ShaderProgram program_;
    DeformUniforms deform_;
    GLint viewProjection_, eye_, slotColors_, opaqueMode_, transparency_, pass_, bumped_;
    GLint keyDirection_, fillDirection_, rimDirection_;
    GLint shadingModel_, shininess_, reflectivity_, ambientLight_, lightCount_;
};

}  // namespace walkcycle
