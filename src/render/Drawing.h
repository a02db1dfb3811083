#pragma once

#include "render/ModelResource.h"
#include "walkcycle/model/Material.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {

// Binds the target, and sets all OpenGL state that drawing relies on and that other code may have changed. Returns
// `encodesItself`: true if the target stores colours as the shader gives them, so that shaders must convert light to
// sRGB. A Framebuffer converts by itself; the framebuffer of a window may not.
bool startDrawingTo(const RenderTarget& target);

// Whether a slot of the material has a texture (whether its picture was found or not).
bool hasTexture(const Material& material, Slot slot);

// Whether a part with this material is drawn with blending: its opacity is below 1, or a texture gives its opacity.
bool showsThrough(const Material& material);

// Whether the shader that draws a model converts light to sRGB. It must if `encodesItself`. If the model has no
// transparent part, it does for any target, because the shader runs once per fragment while a target converts once per
// sample. Blending needs linear light, so if there is a transparent part, the target converts.
bool shaderEncodes(bool encodesItself, const ShaderNeeds& needs);

// Sets blending, and whether depths are written: off for solid parts, on for transparent parts, which write no depths.
void setBlending(bool on);

// The material of parts that have none.
const Material& plainMaterial();

}  // namespace walkcycle
