#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include <glm/vec4.hpp>
#include <walkcycle/Export.h>
#include <walkcycle/io/Image.h>

namespace walkcycle {

// The lighting models of profile_COMMON: <constant>, <lambert>, <phong>, <blinn> (COLLADA 1.4.1, chapter 8).
enum class ShadingModel { Constant, Lambert, Phong, Blinn };

// The inputs of a lighting model that are a colour or a texture. Bump is not in the specification: exporters
// write it into <extra>; its texture holds normals in tangent space.
enum class Slot { Emission, Ambient, Diffuse, Specular, Reflective, Transparent, Bump };
inline constexpr int kSlotCount = 7;

// <wrap_s>, <wrap_t>: what a sampler does outside the picture. Border: Texture::borderColor. Transparent (NONE in the
// file): transparent black.
enum class Wrap { Repeat, Mirror, Clamp, Border, Transparent };
// <minfilter>, <magfilter>, by the names of OpenGL. NONE in the file leaves the default.
enum class Filter {
    Nearest,
    Linear,
    NearestMipmapNearest,
    LinearMipmapNearest,
    NearestMipmapLinear,
    LinearMipmapLinear
};

// A picture with the settings of a sampler (<sampler2D>, <image>).
struct Texture {
    std::string id;    // of the <image>
    std::string uri;   // as the file has it
    std::string path;  // the file that was found; empty if there is none
    std::shared_ptr<const Image>
        image;  // null if it is missing, broken, or not asked for (LoadOptions::loadImages)
    Wrap wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
    Filter minFilter = Filter::LinearMipmapLinear, magFilter = Filter::Linear;
    glm::vec4 borderColor{0.0f};
};

// The value of a Slot.
struct ColorOrTexture {
    bool present = false;                     // whether the file has this slot
    glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};  // as in the file (not linearised)
    // Index into Model::textures; -1: only the colour counts. With a texture, the colour is white, or stands
    // for a missing picture.
    int texture = -1;
    std::string texCoordName;  // <texture texcoord>, which <bind_vertex_input> maps to a set
};

// <transparent opaque>: how opacity() follows from the transparent colour and the transparency.
enum class OpaqueMode { AOne, RgbZero, AZero, RgbOne };

// An <effect> with the parameters of a <material>.
struct Material {
    std::string id, name;
    ShadingModel shading = ShadingModel::Lambert;
    std::array<ColorOrTexture, kSlotCount> slots;
    float shininess = 0.0f;     // exponent of the specular highlight
    float reflectivity = 0.0f;  // 0 to 1
    float transparency = 1.0f;  // factor of the transparent slot: see opacity()
    float indexOfRefraction = 1.0f;
    OpaqueMode opaque = OpaqueMode::AOne;
    bool transparent = false;  // must be drawn with blending
    bool doubleSided = false;

    const ColorOrTexture& slot(Slot s) const { return slots[static_cast<std::size_t>(s)]; }
    ColorOrTexture& slot(Slot s) { return slots[static_cast<std::size_t>(s)]; }
};

// The opacity of the material, from 0 to 1, with this colour in its transparent slot (COLLADA 1.4.1, chapter
// 7, "Determining transparency (opacity)").
WALKCYCLE_API float opacity(const Material& material, const glm::vec4& transparentColor);

}  // namespace walkcycle
