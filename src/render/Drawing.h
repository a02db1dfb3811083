#pragma once

#include "model/Material.h"
#include "render/ModelResource.h"
#include "render/RenderTarget.h"

namespace walkcycle {

// Sets everything that drawing relies on and that somebody else may have changed. Returns whether shaders must turn
// light into sRGB: a framebuffer of ours does it by itself, a window's may not.
bool startDrawingTo(const RenderTarget& target);

bool hasTexture(const Material& material, Slot slot);
bool showsThrough(const Material& material);

// Blending takes place in light, so the target must turn that into sRGB. Without blending the shader does it, once a
// fragment, where the target would once a sample.
bool shaderEncodes(bool encodesItself, const ShaderNeeds& needs);

// For solid parts, or for parts that show through.
void setBlending(bool on);

// What a part without a material looks like.
const Material& plainMaterial();

}  // namespace walkcycle
