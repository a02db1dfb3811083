#include "render/Drawing.h"

#include "render/PictureState.h"

namespace walkcycle {
namespace {

// Whether the target stores colours without a conversion to sRGB.
bool mustEncode(const RenderTarget& target) {
    const GLenum attachment = target.framebuffer == 0 ? GL_BACK_LEFT : GL_COLOR_ATTACHMENT0;
    GLint encoding = GL_LINEAR;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment,
                                          GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, &encoding);
    return encoding != GL_SRGB;
}

}  // namespace

bool startDrawingTo(const RenderTarget& target) {
    if (target.picture) target.picture->drawn = ScreenArea::whole();
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, target.width, target.height);
    const bool encodesItself = mustEncode(target);
    (encodesItself ? glDisable : glEnable)(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);  // COLLADA shows both sides
    glDepthFunc(GL_LEQUAL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    return encodesItself;
}

bool shaderEncodes(bool encodesItself, const ShaderNeeds& needs) {
    return encodesItself || !needs.seeThrough;
}

void setBlending(bool on) {
    glEnable(GL_DEPTH_TEST);
    glDepthMask(on ? GL_FALSE : GL_TRUE);
    (on ? glEnable : glDisable)(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

bool hasTexture(const Material& material, Slot slot) {
    return material.slot(slot).texture >= 0;
}

bool showsThrough(const Material& material) {
    if (!material.transparent) return false;
    return hasTexture(material, Slot::Transparent) ||
           opacity(material, material.slot(Slot::Transparent).color) < 1.0f;
}

const Material& plainMaterial() {
    static const Material plain = [] {
        Material material;
        material.slot(Slot::Diffuse) = {
            .present = true, .color = {0.75f, 0.75f, 0.75f, 1.0f}, .texture = -1, .texCoordName = {}};
        return material;
    }();
    return plain;
}

}  // namespace walkcycle
