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

Backdrop::Grid gridOf(const BackgroundRenderer::Ground& ground, bool encodesItself) {
    const float size = std::max(ground.bounds.diagonal() * 0.5f, 1e-6f);
    return {.fromPicture = glm::inverse(ground.camera.viewProjection()),
            .center = ground.bounds.empty() ? glm::vec3(0.0f) : ground.bounds.center(),
            .radius = size * 4.0f,
            .spacing = std::pow(10.0f, std::round(std::log10(size)) - 1.0f),
            .lineColor = glm::vec4(asTaken(kLine, encodesItself), kLineStrength)};
}

Backdrop backdropOf(const RenderOptions& options, bool encodesItself,
                    const BackgroundRenderer::Ground* ground) {
    const bool gradient = options.background == Background::Gradient;
    Backdrop backdrop{.top = asTaken(gradient ? kTop : options.backgroundColor, encodesItself),
                      .bottom = asTaken(gradient ? kBottom : options.backgroundColor, encodesItself),
                      .grid = {}};
    if (ground) backdrop.grid = gridOf(*ground, encodesItself);
    return backdrop;
}

}  // namespace

void BackgroundRenderer::render(const RenderOptions& options, bool encodesItself, const Ground* ground,
                                const RenderTarget& target) {
    const bool plainColor = options.background == Background::Color && !ground;
    const bool empty = options.background == Background::None || plainColor;
    if (target.underlay) target.underlay->reset();
    clear(plainColor ? glm::vec4(asTaken(options.backgroundColor, encodesItself), 1.0f) : glm::vec4(0.0f));
    if (empty) return;
    const Backdrop backdrop = backdropOf(options, encodesItself, ground);
    if (target.underlay) {
        *target.underlay = backdrop;
        return;
    }
    auto& program = ground ? withGrid_ : plain_;
    if (!program) program.emplace(backdrop);
    program->program.start();
    backdrop.load(program->program);
    program->noInputs.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace walkcycle
