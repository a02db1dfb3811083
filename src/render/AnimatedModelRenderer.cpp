#include "walkcycle/render/AnimatedModelRenderer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "render/AnimatedModelShader.h"
#include "render/BackgroundRenderer.h"
#include "render/CurrentContext.h"
#include "render/Drawing.h"
#include "render/FileLights.h"
#include "render/InstanceStates.h"
#include "render/PictureState.h"
#include "render/SkeletonRenderer.h"
#include "render/VertexInput.h"

namespace walkcycle {
namespace {

using Pass = AnimatedModelShader::Pass;

// The colour of the wireframe: dark, and half transparent so that a dense mesh does not become black. Linear light,
// premultiplied.
constexpr glm::vec4 kEdges{0.008f, 0.009f, 0.011f, 0.55f};

struct Wireframe {
    ShaderProgram program;
    DeformUniforms deform;

    Wireframe()
        : program({{"animatedModelVertex"}, {"flatFragment"}},
                  deformDefines({.morphs = true, .moreInfluences = true})),
          deform((program.start(), program)) {}
};

}  // namespace

struct AnimatedModelRenderer::Impl {
    // A part to draw in this picture.
    struct Draw {
        std::size_t instance = 0;
        const ModelResource::Part* part = nullptr;
        const Material* material = nullptr;
        float distance = 0.0f;  // from the camera, for the order of transparent parts
    };
    // The arguments of one picture.
    struct Scene {
        const AnimatedModel& model;
        const Camera& camera;
        const RenderOptions& options;
        bool encodesItself;  // as startDrawingTo() returns it
    };

    std::map<AnimatedModelShader::Variant, AnimatedModelShader> shaders;
    InstanceStates states;
    FileLights lights;
    BufferTexture lightTexture{GL_RGBA32F};
    std::vector<Draw> solid, seeThrough;
    BackgroundRenderer background;
    std::optional<SkeletonRenderer> skeleton;  // made when it is first needed
    std::optional<Wireframe> wireframe;

    const AnimatedModelShader& shaderFor(const Scene& scene);
    void prepare(const Scene& scene);
    void sortParts(const Scene& scene);
    void drawSolid(const Scene& scene, const AnimatedModelShader& shader);
    void drawSeeThrough(const Scene& scene, const AnimatedModelShader& shader);
    void drawPart(const Scene& scene, const AnimatedModelShader& shader, const Draw& draw, Pass pass);
    void drawWireframe(const Scene& scene);
    void drawModel(const Scene& scene);
};

const AnimatedModelShader& AnimatedModelRenderer::Impl::shaderFor(const Scene& scene) {
    const ShaderNeeds& needs = scene.model.resource()->needs();
    const AnimatedModelShader::Variant variant{scene.options.lights,
                                               shaderEncodes(scene.encodesItself, needs), needs};
    return shaders.try_emplace(variant, variant).first->second;
}

void AnimatedModelRenderer::Impl::prepare(const Scene& scene) {
    states.prepare(scene.model);
    sortParts(scene);
    if (scene.options.lights != Lighting::File) return;
    lights.gather(scene.model, scene.camera);
    lightTexture.store(std::span<const glm::vec4>(lights.texels()), GL_STREAM_DRAW);
    lightTexture.bind(TextureUnit::kLights);
}

// Fills `solid` in the file's order, and `seeThrough` with the farthest part first: a transparent part blends with
// the colours behind it, which must be in the picture already.
void AnimatedModelRenderer::Impl::sortParts(const Scene& scene) {
    solid.clear();
    seeThrough.clear();
    const auto& instances = scene.model.resource()->instances();
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (!states.states()[i].visible) continue;
        for (const ModelResource::Part& part : instances[i].parts) {
            if (part.indexCount == 0) continue;
            Draw draw{i, &part, &plainMaterial()};
            if (part.material >= 0)
                draw.material = &scene.model.scene().materials[static_cast<std::size_t>(part.material)];
            if (!showsThrough(*draw.material)) {
                solid.push_back(draw);
                continue;
            }
            const glm::vec3 middle = states.position(scene.model, i, part.middle);
            draw.distance = -(scene.camera.view * glm::vec4(middle, 1.0f)).z;
            seeThrough.push_back(draw);
        }
    }
    std::sort(seeThrough.begin(), seeThrough.end(), [](const Draw& a, const Draw& b) {
        return a.distance != b.distance ? a.distance > b.distance : a.part < b.part;
    });
}

void AnimatedModelRenderer::Impl::drawPart(const Scene& scene, const AnimatedModelShader& shader,
                                           const Draw& draw, Pass pass) {
    shader.loadInstance(states.bind(scene.model, draw.instance));
    shader.loadMaterial(*draw.material, *scene.model.resource());
    shader.loadPass(pass);
    scene.model.resource()->vao(draw.part->vao).bind();
    const auto offset = static_cast<std::uintptr_t>(draw.part->firstIndex) * sizeof(std::uint32_t);
    glDrawElements(draw.part->primitive == Primitive::Lines ? GL_LINES : GL_TRIANGLES,
                   static_cast<GLsizei>(draw.part->indexCount), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));
}

void AnimatedModelRenderer::Impl::drawSolid(const Scene& scene, const AnimatedModelShader& shader) {
    setBlending(false);
    if (scene.options.wireframe) {
        glEnable(GL_POLYGON_OFFSET_FILL);  // moves surfaces back, so that the edges lie in front
        glPolygonOffset(1.0f, 1.0f);
    }
    for (const Draw& draw : solid) drawPart(scene, shader, draw, Pass::All);
    // The opaque pixels of hair and leaves are drawn with the solid parts, so that they hide the parts behind them in
    // any order. The other pixels follow in drawSeeThrough().
    for (const Draw& draw : seeThrough) {
        if (hasTexture(*draw.material, Slot::Transparent)) drawPart(scene, shader, draw, Pass::Solid);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void AnimatedModelRenderer::Impl::drawSeeThrough(const Scene& scene, const AnimatedModelShader& shader) {
    if (seeThrough.empty()) return;
    shader.start();
    setBlending(true);
    for (const Draw& draw : seeThrough) {
        drawPart(scene, shader, draw, Pass::Backs);
        drawPart(scene, shader, draw, Pass::Fronts);
    }
    setBlending(false);
}

void AnimatedModelRenderer::Impl::drawWireframe(const Scene& scene) {
    if (!wireframe) wireframe.emplace();
    const ShaderProgram& program = wireframe->program;
    program.start();
    setUniform(program.uniform("viewProjection"), scene.camera.viewProjection());
    setUniform(program.uniform("encodesItself"), scene.encodesItself ? 1 : 0);
    setUniform(program.uniform("flatColor"), kEdges);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    for (const auto* draws : {&solid, &seeThrough}) {
        for (const Draw& draw : *draws) {
            if (draw.part->primitive == Primitive::Lines) continue;
            wireframe->deform.load(states.bind(scene.model, draw.instance));
            scene.model.resource()->vao(draw.part->vao).bind();
            const auto offset = static_cast<std::uintptr_t>(draw.part->firstIndex) * sizeof(std::uint32_t);
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(draw.part->indexCount), GL_UNSIGNED_INT,
                           reinterpret_cast<const void*>(offset));
        }
    }
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDisable(GL_BLEND);
}

void AnimatedModelRenderer::Impl::drawModel(const Scene& scene) {
    const AnimatedModelShader& shader = shaderFor(scene);
    prepare(scene);
    shader.start();
    shader.loadCamera(scene.camera);
    if (scene.options.lights == Lighting::File) shader.loadLights(lights);
    if (shaderEncodes(scene.encodesItself, scene.model.resource()->needs())) glDisable(GL_FRAMEBUFFER_SRGB);
    drawSolid(scene, shader);
    drawSeeThrough(scene, shader);
    if (!scene.encodesItself) glEnable(GL_FRAMEBUFFER_SRGB);
    if (scene.options.wireframe) drawWireframe(scene);
    if (scene.options.skeleton) {
        if (!skeleton) skeleton.emplace();
        skeleton->render(scene.model, scene.camera, scene.encodesItself);
    }
}

AnimatedModelRenderer::AnimatedModelRenderer() {
    requireContext();
    impl_ = std::make_unique<Impl>();
}
AnimatedModelRenderer::~AnimatedModelRenderer() = default;
AnimatedModelRenderer::AnimatedModelRenderer(AnimatedModelRenderer&&) noexcept = default;
AnimatedModelRenderer& AnimatedModelRenderer::operator=(AnimatedModelRenderer&&) noexcept = default;

void AnimatedModelRenderer::render(const AnimatedModel& model, const Camera& camera,
                                   const RenderTarget& target, const RenderOptions& options) {
    const bool encodesItself = startDrawingTo(target);
    if (options.grid) {
        const BackgroundRenderer::Ground ground{camera, model.bounds()};
        impl_->background.render(options, encodesItself, &ground, target);
    } else {
        impl_->background.render(options, encodesItself, nullptr, target);
    }
    impl_->drawModel({model, camera, options, encodesItself});
    if (target.picture && !options.skeleton)
        target.picture->drawn = impl_->states.area(model, camera, target);
}

void AnimatedModelRenderer::clear(const RenderTarget& target, const RenderOptions& options) {
    impl_->background.render(options, startDrawingTo(target), nullptr, target);
}

void AnimatedModelRenderer::draw(const AnimatedModel& model, const Camera& camera, const RenderTarget& target,
                                 const RenderOptions& options) {
    impl_->drawModel({model, camera, options, startDrawingTo(target)});
}

}  // namespace walkcycle
