#include "render/Srgb.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace walkcycle {
namespace {

constexpr int kSteps = 4096;

struct Tables {
    std::array<float, 256> linear;  // byte -> light
    std::array<float, 256> limit;   // byte -> the light from which on byte + 1 is nearer
    std::array<std::uint8_t, kSteps + 1>
        byteAt;  // step -> the byte of the light step / kSteps: a search begins there

    Tables() {
        for (std::size_t i = 0; i < 256; ++i) {
            linear[i] = linearOfSrgb(static_cast<float>(i) / 255.0f);
            limit[i] = linearOfSrgb((static_cast<float>(i) + 0.5f) / 255.0f);
        }
        std::uint8_t byte = 0;
        for (std::size_t i = 0; i <= kSteps; ++i) {
            while (byte < 255 && limit[byte] < static_cast<float>(i) / kSteps) ++byte;
            byteAt[i] = byte;
        }
    }
};

const Tables& tables() {
    static const Tables instance;
    return instance;
}

}  // namespace

float linearOfSrgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float linearOfSrgb(std::uint8_t encoded) {
    return tables().linear[encoded];
}

std::uint8_t srgbOfLinear(float light) {
    if (!(light > 0.0f)) return 0;
    if (light >= 1.0f) return 255;
    const Tables& t = tables();
    std::uint8_t byte = t.byteAt[static_cast<std::size_t>(light * kSteps)];
    while (byte < 255 && t.limit[byte] < light) ++byte;
    return byte;
}

glm::vec3 linearOfSrgb(const glm::vec3& encoded) {
    return {linearOfSrgb(encoded.x), linearOfSrgb(encoded.y), linearOfSrgb(encoded.z)};
}

}  // namespace walkcycle
