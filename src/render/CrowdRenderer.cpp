#include "walkcycle/render/CrowdRenderer.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <map>

#include "render/AnimatedModelShader.h"
#include "render/CurrentContext.h"
#include "render/Drawing.h"
#include "render/FileLights.h"
#include "render/InstanceStates.h"
#include "render/VertexInput.h"
#include "walkcycle/animation/Skin.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {
namespace {

using Pass = AnimatedModelShader::Pass;

constexpr std::size_t kRowsPerJoint = 3;

constexpr std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

// The skin of an instance; null if its node alone moves it.
const Skin* skinOf(const Model& model, const MeshInstance& instance) {
    for (const Deformer& deformer : instance.deformers)
        if (deformer.kind == Deformer::Kind::Skin) return &model.skins[index(deformer.index)];
    return nullptr;
}

std::size_t matrixCount(const Model& model, const MeshInstance& instance) {
    const Skin* skin = skinOf(model, instance);
    return skin ? skin->joints.size() : 1;
}

void requireShader(const AnimatedModel& model) {
    for (const ModelResource::Instance& instance : model.resource()->instances())
        if (instance.deformedOnCpu)
            throw GraphicsError("the shader cannot deform this model, so it cannot be drawn as a crowd");
}

// The passes that draw a part with this material: in the first round, which draws opaque fragments, or (`seeThrough`)
// in the second, which draws transparent ones. They are the same as in AnimatedModelRenderer.
std::vector<Pass> passes(const Material& material, bool seeThrough) {
    if (!showsThrough(material)) return seeThrough ? std::vector<Pass>{} : std::vector{Pass::All};
    if (seeThrough) return {Pass::Backs, Pass::Fronts};
    return hasTexture(material, Slot::Transparent) ? std::vector{Pass::Solid} : std::vector<Pass>{};
}

}  // namespace

struct CrowdRenderer::Impl {
    struct Scene {
        const AnimatedModel& model;
        const AnimatedModelShader& shader;
        std::size_t stride;   // matrices per walker
        std::size_t page;     // index into `pages`
        std::size_t walkers;  // in this page
    };

    explicit Impl(std::size_t maxTexels) : maxJoints(maxTexels / kRowsPerJoint) {}

    const AnimatedModelShader& start(const AnimatedModel& model, const Camera& camera, bool encodes,
                                     const RenderOptions& options);
    std::size_t upload(std::span<const JointRows> palettes, std::size_t stride);
    void drawPage(const Scene& scene, bool seeThrough);
    void drawPart(const Scene& scene, std::size_t instance, std::size_t firstJoint,
                  const ModelResource::Part& part);

    std::map<AnimatedModelShader::Variant, AnimatedModelShader> shaders;
    InstanceStates states;
    FileLights lights;
    BufferTexture lightTexture{GL_RGBA32F};
    std::size_t maxJoints;             // the most matrices in a page
    std::vector<BufferTexture> pages;  // the palettes, as many whole ones in each page as fit
};

const AnimatedModelShader& CrowdRenderer::Impl::start(const AnimatedModel& model, const Camera& camera,
                                                      bool encodes, const RenderOptions& options) {
    const AnimatedModelShader::Variant variant{options.lights, encodes, model.resource()->needs()};
    const AnimatedModelShader& shader = shaders.try_emplace(variant, variant).first->second;
    states.prepare(model);
    shader.start();
    shader.loadCamera(camera);
    if (options.lights != Lighting::File) return shader;
    lights.gather(model, camera);
    lightTexture.store(std::span<const glm::vec4>(lights.texels()), GL_STREAM_DRAW);
    lightTexture.bind(TextureUnit::kLights);
    shader.loadLights(lights);
    return shader;
}

// Copies the palettes into `pages`. Returns the number of walkers per page.
std::size_t CrowdRenderer::Impl::upload(std::span<const JointRows> palettes, std::size_t stride) {
    const std::size_t walkersAPage = maxJoints / stride;
    if (walkersAPage == 0)
        throw GraphicsError("the palette of one walker is larger than a texture buffer of this device");
    std::size_t page = 0;
    for (std::size_t at = 0; at < palettes.size(); at += walkersAPage * stride) {
        if (page == pages.size()) pages.emplace_back(GL_RGBA32F);
        const std::size_t count = std::min(walkersAPage * stride, palettes.size() - at);
        pages[page++].store(palettes.subspan(at, count), GL_STREAM_DRAW);
    }
    return walkersAPage;
}

void CrowdRenderer::Impl::drawPart(const Scene& scene, std::size_t instance, std::size_t firstJoint,
                                   const ModelResource::Part& part) {
    DeformUniforms::Values deform = states.bind(scene.model, instance);
    pages[scene.page].bind(TextureUnit::kPalette);  // in place of the model's own
    deform.firstJoint = static_cast<int>(firstJoint);
    deform.jointsPerWalker = static_cast<int>(scene.stride);
    scene.shader.loadInstance(deform);
    scene.model.resource()->vao(part.vao).bind();
    const auto offset = static_cast<std::uintptr_t>(part.firstIndex) * sizeof(std::uint32_t);
    glDrawElementsInstanced(part.primitive == Primitive::Lines ? GL_LINES : GL_TRIANGLES,
                            static_cast<GLsizei>(part.indexCount), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(offset), static_cast<GLsizei>(scene.walkers));
}

void CrowdRenderer::Impl::drawPage(const Scene& scene, bool seeThrough) {
    const auto& instances = scene.model.resource()->instances();
    std::size_t nextJoint = 0;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const std::size_t firstJoint = nextJoint;
        nextJoint += matrixCount(scene.model.model(), scene.model.model().instances[i]);
        if (!states.states()[i].visible) continue;
        for (const ModelResource::Part& part : instances[i].parts) {
            const Material& material =
                part.material < 0 ? plainMaterial() : scene.model.scene().materials[index(part.material)];
            for (const Pass pass : passes(material, seeThrough)) {
                scene.shader.loadMaterial(material, *scene.model.resource());
                scene.shader.loadPass(pass);
                if (part.indexCount > 0) drawPart(scene, i, firstJoint, part);
            }
        }
    }
}

CrowdRenderer::CrowdRenderer() : CrowdRenderer(BufferTexture::maxTexels()) {}
CrowdRenderer::CrowdRenderer(std::size_t maxTexels) {
    requireContext();
    impl_ = std::make_unique<Impl>(maxTexels);
}
CrowdRenderer::~CrowdRenderer() = default;
CrowdRenderer::CrowdRenderer(CrowdRenderer&&) noexcept = default;
CrowdRenderer& CrowdRenderer::operator=(CrowdRenderer&&) noexcept = default;

void CrowdRenderer::draw(const AnimatedModel& model, std::span<const JointRows> palettes,
                         const Camera& camera, const RenderTarget& target, const RenderOptions& options) {
    const std::size_t stride = jointsPerWalker(model.model());
    assert(stride == 0 || palettes.size() % stride == 0);
    if (palettes.empty() || stride == 0) return;
    requireShader(model);
    const std::size_t walkersAPage = impl_->upload(palettes, stride), all = palettes.size() / stride;
    const bool encodesItself = startDrawingTo(target);
    const bool encodes = shaderEncodes(encodesItself, model.resource()->needs());
    if (encodes) glDisable(GL_FRAMEBUFFER_SRGB);
    const AnimatedModelShader& shader = impl_->start(model, camera, encodes, options);
    for (const bool seeThrough : {false, true}) {
        setBlending(seeThrough);
        for (std::size_t page = 0; page * walkersAPage < all; ++page) {
            const std::size_t walkers = std::min(walkersAPage, all - page * walkersAPage);
            impl_->drawPage({model, shader, stride, page, walkers}, seeThrough);
        }
    }
    setBlending(false);
}

std::size_t jointsPerWalker(const Model& model) {
    std::size_t count = 0;
    for (const MeshInstance& instance : model.instances) count += matrixCount(model, instance);
    return count;
}

void appendPalette(const AnimatedModel& model, std::vector<JointRows>& palettes) {
    const auto& transforms = model.animator().modelTransforms();
    for (const MeshInstance& instance : model.model().instances) {
        const Skin* skin = skinOf(model.model(), instance);
        const std::size_t first = palettes.size();
        palettes.resize(first + matrixCount(model.model(), instance));
        const std::span<JointRows> palette = std::span(palettes).subspan(first);
        if (skin)
            computePalette(*skin, transforms, palette);
        else
            palette[0] = JointRows(transforms[index(instance.node)]);
    }
}

}  // namespace walkcycle
