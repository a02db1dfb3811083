#pragma once

#include "render/ModelResource.h"
#include "walkcycle/model/Material.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {

// Sets all OpenGL state that drawing relies on and that other code may have changed. Returns whether shaders
// must convert light to sRGB: our own framebuffers do that themselves, a window's may not.
bool startDrawingTo(const RenderTarget& target);

bool hasTexture(const Material& material, Slot slot);
bool showsThrough(const Material& material);

// Whether the shader converts light to sRGB. Blending needs linear light, so with blending the target must
// convert. Without blending the shader does, because it runs once per fragment and the target converts once
// per sample.
bool shaderEncodes(bool encodesItself, const ShaderNeeds& needs);

// Off for solid parts, on for transparent parts.
void setBlending(bool on);

// The material of parts that have none.
const Material& plainMaterial();

}  // namespace walkcycle
