#include "render/BackgroundRenderer.h"

#include "render/Srgb.h"

namespace walkcycle {

BackgroundRenderer::BackgroundRenderer()
    : program_({{"backgroundVertex"}, {"backgroundFragment"}}),
      top_(program_.uniform("top")),
      bottom_(program_.uniform("bottom")),
      encodesItself_(program_.uniform("encodesItself")) {}

void BackgroundRenderer::render(const RenderOptions& options, bool encodesItself) const {
    const glm::vec3& wanted = options.backgroundColor;
    const glm::vec3 color = encodesItself ? wanted : linearOfSrgb(wanted);
    const bool transparent = options.background == Background::None;
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearDepth(1.0);
    glClearColor(transparent ? 0.0f : color.r, transparent ? 0.0f : color.g, transparent ? 0.0f : color.b,
                 transparent ? 0.0f : 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (options.background != Background::Gradient) return;

    program_.start();
    setUniform(top_, glm::vec3(0.60f, 0.63f, 0.67f));
    setUniform(bottom_, glm::vec3(0.80f, 0.80f, 0.79f));
    setUniform(encodesItself_, encodesItself ? 1 : 0);
    noInputs_.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace walkcycle
