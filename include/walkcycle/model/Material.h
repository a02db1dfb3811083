#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include <glm/vec4.hpp>
#include <walkcycle/Export.h>
#include <walkcycle/io/Image.h>

namespace walkcycle {

// profile_COMMON's four lighting models (COLLADA 1.4.1, chapter 7: <constant>, <lambert>, <phong>, <blinn>).
enum class ShadingModel { Constant, Lambert, Phong, Blinn };

enum class Slot { Emission, Ambient, Diffuse, Specular, Reflective, Transparent, Bump };
inline constexpr int kSlotCount = 7;

enum class Wrap { Repeat, Mirror, Clamp, Border, None };
enum class Filter {
    None,
    Nearest,
    Linear,
    NearestMipmapNearest,
    LinearMipmapNearest,
    NearestMipmapLinear,
    LinearMipmapLinear
};

// A picture as a sampler of the file uses it.
struct Texture {
    std::string id;                      // of the <image>
    std::string uri;                     // as the file has it
    std::string path;                    // the file that was found; empty if there is none
    std::shared_ptr<const Image> image;  // null if it is missing or broken, or if images were not asked for
    Wrap wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
    Filter minFilter = Filter::LinearMipmapLinear, magFilter = Filter::Linear;
    glm::vec4 borderColor{0.0f};
};

struct ColorOrTexture {
    bool present = false;                     // the file has this slot
    glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};  // as in the file (not linearised)
    int texture = -1;  // index into Model::textures; then color is white, or stands for a missing picture
    std::string texCoordName;  // the semantic for which <bind_vertex_input> names a set
};

enum class OpaqueMode { AOne, RgbZero, AZero, RgbOne };

// An <effect> as a <material> instantiates it.
struct Material {
    std::string id, name;
    ShadingModel shading = ShadingModel::Lambert;
    std::array<ColorOrTexture, kSlotCount> slots;
    float shininess = 0.0f;
    float reflectivity = 0.0f;
    float transparency = 1.0f;
    float indexOfRefraction = 1.0f;
    OpaqueMode opaque = OpaqueMode::AOne;
    bool transparent = false;  // draw with blending; exporters that invert transparency are accounted for
    bool doubleSided = false;

    const ColorOrTexture& slot(Slot s) const { return slots[static_cast<std::size_t>(s)]; }
    ColorOrTexture& slot(Slot s) { return slots[static_cast<std::size_t>(s)]; }
};

// The opacity of the material, from 0 to 1, if its transparent slot has this colour (COLLADA 1.4.1,
// "Determining transparency (opacity)").
WALKCYCLE_API float opacity(const Material& material, const glm::vec4& transparentColor);

}  // namespace walkcycle
