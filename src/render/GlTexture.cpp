#include "render/GlTexture.h"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>

#include "render/Srgb.h"

namespace walkcycle {
namespace {

GLuint newTexture() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
}

// COLLADA 1.4.1, <wrap_s>: NONE is decal texturing, black and transparent outside the picture.
GLint glWrap(Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat:
            return GL_REPEAT;
        case Wrap::Mirror:
            return GL_MIRRORED_REPEAT;
        case Wrap::Clamp:
            return GL_CLAMP_TO_EDGE;
        case Wrap::Border:
        case Wrap::Transparent:
            return GL_CLAMP_TO_BORDER;
    }
    return GL_REPEAT;
}

GLint glMinFilter(Filter filter) {
    switch (filter) {
        case Filter::Nearest:
            return GL_NEAREST;
        case Filter::Linear:
            return GL_LINEAR;
        case Filter::NearestMipmapNearest:
            return GL_NEAREST_MIPMAP_NEAREST;
        case Filter::LinearMipmapNearest:
            return GL_LINEAR_MIPMAP_NEAREST;
        case Filter::NearestMipmapLinear:
            return GL_NEAREST_MIPMAP_LINEAR;
        case Filter::LinearMipmapLinear:
            return GL_LINEAR_MIPMAP_LINEAR;
    }
    return GL_LINEAR_MIPMAP_LINEAR;
}

GLint glMagFilter(Filter filter) {
    const bool nearest = filter == Filter::Nearest || filter == Filter::NearestMipmapNearest ||
                         filter == Filter::NearestMipmapLinear;
    return nearest ? GL_NEAREST : GL_LINEAR;
}

bool usesMipMaps(GLint minFilter) {
    return minFilter != GL_NEAREST && minFilter != GL_LINEAR;
}

// OpenGL converts the texels of a Color picture to linear light, but not the border colour. So it is converted here.
glm::vec4 borderColor(const Texture& texture, TexelKind kind) {
    if (texture.wrapS == Wrap::Transparent || texture.wrapT == Wrap::Transparent) return glm::vec4(0.0f);
    const glm::vec4& border = texture.borderColor;
    return kind == TexelKind::Color ? glm::vec4(linearOfSrgb(glm::vec3(border)), border.a) : border;
}

void upload(GLint level, const Image& image, TexelKind kind) {
    const GLint format = kind == TexelKind::Color ? GL_SRGB8_ALPHA8 : GL_RGBA8;
    glTexImage2D(GL_TEXTURE_2D, level, format, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
}

int maxTextureSize() {
    GLint size = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    return size;
}

void uploadLevels(const Image& picture, TexelKind kind, bool withMipMaps) {
    const int largest = maxTextureSize();
    Image smaller;
    const Image* top = &picture;
    while (std::max(top->width, top->height) > largest) {
        smaller = halved(*top, kind);
        top = &smaller;
    }
    upload(0, *top, kind);
    GLint level = 0;
    if (withMipMaps) {
        for (const Image& image : mipMaps(*top, kind)) upload(++level, image, kind);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level);
}

}  // namespace

GlTexture::GlTexture() : texture_(newTexture()) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

GlTexture::GlTexture(const Texture& texture, TexelKind kind) : GlTexture() {
    const GLint minFilter = glMinFilter(texture.minFilter);
    // Set first: otherwise some drivers allocate a single level, and everything again when the second level
    // arrives.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minFilter);
    uploadLevels(*texture.image, kind, usesMipMaps(minFilter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, glMagFilter(texture.magFilter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, glWrap(texture.wrapS));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, glWrap(texture.wrapT));
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, glm::value_ptr(borderColor(texture, kind)));
}

GlTexture GlTexture::white() {
    GlTexture texture;
    const Image texel{.width = 1, .height = 1, .hasAlpha = false, .rgba = {255, 255, 255, 255}};
    upload(0, texel, TexelKind::Data);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

void GlTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture_.id());
}

}  // namespace walkcycle
