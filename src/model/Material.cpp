#include "walkcycle/model/Material.h"

#include <algorithm>

namespace walkcycle {
namespace {

// The weights of CIE linear luminance that the specification gives.
float luminance(const glm::vec4& color) {
    return color.r * 0.212671f + color.g * 0.715160f + color.b * 0.072169f;
}

}  // namespace

float opacity(const Material& material, const glm::vec4& transparentColor) {
    float result = 1.0f;
    switch (material.opaque) {
        case OpaqueMode::AOne:
            result = transparentColor.a * material.transparency;
            break;
        case OpaqueMode::RgbZero:
            result = 1.0f - luminance(transparentColor) * material.transparency;
            break;
        case OpaqueMode::AZero:
            result = 1.0f - transparentColor.a * material.transparency;
            break;
        case OpaqueMode::RgbOne:
            result = luminance(transparentColor) * material.transparency;
            break;
    }
    return std::clamp(result, 0.0f, 1.0f);
}

}  // namespace walkcycle
