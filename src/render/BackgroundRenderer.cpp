#include "render/BackgroundRenderer.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include "render/Srgb.h"

namespace walkcycle {
namespace {

constexpr glm::vec3 kTop{0.60f, 0.63f, 0.67f}, kBottom{0.80f, 0.80f, 0.79f};  // sRGB
constexpr glm::vec3 kLine{0.35f, 0.35f, 0.36f};
constexpr float kLineStrength = 0.55f;

void clear(const glm::vec4& color) {
    glDepthMask(GL_TRUE);
    glClearDepth(1.0);
    glClearColor(color.r, color.g, color.b, color.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

glm::vec3 asTaken(const glm::vec3& srgb, bool encodesItself) {
    return encodesItself ? srgb : linearOfSrgb(srgb);
}

}  // namespace

void BackgroundRenderer::render(const RenderOptions& options, bool encodesItself, const Ground* ground) {
    const bool transparent = options.background == Background::None;
    clear(transparent ? glm::vec4(0.0f) : glm::vec4(asTaken(options.backgroundColor, encodesItself), 1.0f));
    if (transparent || (options.background == Background::Color && !ground)) return;
    auto& backdrop = ground ? withGrid_ : plain_;
    if (!backdrop) backdrop.emplace(ground ? "#define GRID\n" : "");
    backdrop->draw(options, encodesItself, ground);
}

void BackgroundRenderer::Backdrop::draw(const RenderOptions& options, bool encodesItself,
                                        const Ground* ground) const {
    const bool gradient = options.background == Background::Gradient;
    program_.start();
    setUniform(program_.uniform("top"), asTaken(gradient ? kTop : options.backgroundColor, encodesItself));
    setUniform(program_.uniform("bottom"),
               asTaken(gradient ? kBottom : options.backgroundColor, encodesItself));
    if (ground) loadGround(*ground, encodesItself);
    noInputs_.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void BackgroundRenderer::Backdrop::loadGround(const Ground& ground, bool encodesItself) const {
    const float size = std::max(ground.bounds.diagonal() * 0.5f, 1e-6f);
    setUniform(program_.uniform("fromPicture"), glm::inverse(ground.camera.viewProjection()));
    setUniform(program_.uniform("center"), ground.bounds.empty() ? glm::vec3(0.0f) : ground.bounds.center());
    setUniform(program_.uniform("radius"), size * 4.0f);
    setUniform(program_.uniform("spacing"), std::pow(10.0f, std::round(std::log10(size)) - 1.0f));
    setUniform(program_.uniform("lineColor"), glm::vec4(asTaken(kLine, encodesItself), kLineStrength));
}

}  // namespace walkcycle
