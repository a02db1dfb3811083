#include "render/BackgroundRenderer.h"

#include "render/Srgb.h"

namespace walkcycle {
namespace {

constexpr glm::vec3 kTop{0.60f, 0.63f, 0.67f}, kBottom{0.80f, 0.80f, 0.79f};  // sRGB

}  // namespace

void BackgroundRenderer::render(const RenderOptions& options, bool encodesItself) {
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

    if (!gradient_) gradient_.emplace();
    const ShaderProgram& program = gradient_->program;
    program.start();
    setUniform(program.uniform("top"), encodesItself ? kTop : linearOfSrgb(kTop));
    setUniform(program.uniform("bottom"), encodesItself ? kBottom : linearOfSrgb(kBottom));
    gradient_->noInputs.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace walkcycle
