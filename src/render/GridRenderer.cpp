#include "render/GridRenderer.h"

#include <algorithm>
#include <cmath>

namespace walkcycle {

GridRenderer::GridRenderer()
    : program_({{"gridVertex"}, {"gridFragment"}}),
      viewProjection_(program_.uniform("viewProjection")),
      center_(program_.uniform("center")),
      radius_(program_.uniform("radius")),
      spacing_(program_.uniform("spacing")),
      lineColor_(program_.uniform("lineColor")),
      encodesItself_(program_.uniform("encodesItself")) {}

void GridRenderer::render(const Bounds& bounds, const Camera& camera, bool encodesItself) const {
    const float size = std::max(bounds.diagonal() * 0.5f, 1e-6f);
    program_.start();
    setUniform(viewProjection_, camera.viewProjection());
    setUniform(center_, bounds.empty() ? glm::vec3(0.0f) : bounds.center());
    setUniform(radius_, size * 4.0f);
    setUniform(spacing_, std::pow(10.0f, std::round(std::log10(size)) - 1.0f));
    setUniform(lineColor_, glm::vec4(0.10f, 0.10f, 0.11f, 0.55f));
    setUniform(encodesItself_, encodesItself ? 1 : 0);
    noInputs_.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace walkcycle
