#include "render/BackgroundRenderer.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include "render/PictureState.h"
#include "render/Srgb.h"

namespace walkcycle {
namespace {

void clear(const glm::vec4& color) {
    glDepthMask(GL_TRUE);
    glClearDepth(1.0);
    glClearColor(color.r, color.g, color.b, color.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

// The numbers to give to a target for this colour: linear light, or sRGB if the target does not convert.
glm::vec3 asStored(const glm::vec3& srgb, bool encodesItself) {
    return encodesItself ? srgb : linearOfSrgb(srgb);
}

// Computes Backdrop::Grid::groundAt. In model space, in homogeneous coordinates, a point of the picture at depth d is
// A + d * B. A depends on the point, B does not. The ground is at the depth for which y is 0, d = -A.y / B.y, so the
// point of the ground is A - B * A.y / B.y, or (A * B.y - B * A.y) without the division.
glm::mat3x4 groundAt(const Camera& camera, double step) {
    const glm::dmat4 fromPicture = glm::inverse(glm::dmat4(camera.viewProjection()));
    const glm::dvec4 b = fromPicture[2];
    const double sign = b.y < 0.0 ? -1.0 : 1.0;
    const auto column = [&](const glm::dvec4& a) {
        const glm::dvec4 met = (a * b.y - b * a.y) * sign;
        return glm::vec4(met.x / step, met.z / step, met.w, -a.y * sign);
    };
    glm::mat3x4 columns(column(fromPicture[0]), column(fromPicture[1]), column(fromPicture[3]));
    columns[2].w += static_cast<float>(b.y * sign);  // depth -1 is the near plane
    return columns;
}

// The step is the power of ten nearest to a tenth of half the bounds' diagonal.
Backdrop::Grid gridOf(const BackgroundRenderer::Ground& ground) {
    const float size = std::max(ground.bounds.diagonal() * 0.5f, 1e-6f);
    const float step = std::pow(10.0f, std::round(std::log10(size)) - 1.0f);
    const glm::vec3 center = ground.bounds.empty() ? glm::vec3(0.0f) : ground.bounds.center();
    return {.groundAt = groundAt(ground.camera, step),
            .fading = glm::vec3(center.x, center.z, size * 4.0f) / step};
}

Backdrop backdropOf(const RenderOptions& options, bool encodesItself,
                    const BackgroundRenderer::Ground* ground, const RenderTarget& target) {
    Backdrop backdrop{.encodesItself = encodesItself,
                      .pictureHeight = static_cast<float>(target.height),
                      .color = {},
                      .grid = {}};
    if (options.background == Background::Color)
        backdrop.color = asStored(options.backgroundColor, encodesItself);
    if (ground) backdrop.grid = gridOf(*ground);
    return backdrop;
}

}  // namespace

void BackgroundRenderer::render(const RenderOptions& options, bool encodesItself, const Ground* ground,
                                const RenderTarget& target) {
    const bool plainColor = options.background == Background::Color && !ground;
    const bool empty = options.background == Background::Transparent || plainColor;
    std::optional<Backdrop>* const underlay = target.picture ? target.picture->underlay() : nullptr;
    if (underlay) underlay->reset();
    clear(plainColor ? glm::vec4(asStored(options.backgroundColor, encodesItself), 1.0f) : glm::vec4(0.0f));
    if (empty) return;
    const Backdrop backdrop = backdropOf(options, encodesItself, ground, target);
    if (underlay) {
        *underlay = backdrop;
        return;
    }
    std::optional<Program>& found = programs_[backdrop.variant()];
    if (!found) found.emplace(backdrop.defines());
    found->program.start();
    backdrop.load(found->program);
    found->noInputs.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace walkcycle
