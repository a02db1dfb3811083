#include "loaders/materials/BumpMap.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace walkcycle {
namespace {

constexpr float kHeightOfWhite = 4.0f;  // in texels

float heightAt(const Image& image, int x, int y) {
    const int column = (x + image.width) % image.width;  // most textures repeat
    const int row = (y + image.height) % image.height;
    const std::size_t texel = static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(column);
    return static_cast<float>(image.rgba[texel * 4]) / 255.0f * kHeightOfWhite;
}

std::uint8_t asByte(float component) {
    return static_cast<std::uint8_t>(std::lround((component * 0.5f + 0.5f) * 255.0f));
}

}  // namespace

bool holdsHeights(const Image& image) {
    for (std::size_t i = 0; i + 2 < image.rgba.size(); i += 4)
        if (image.rgba[i] != image.rgba[i + 1] || image.rgba[i] != image.rgba[i + 2]) return false;
    return true;
}

Image normalsOfHeights(const Image& heights) {
    Image normals{.width = heights.width, .height = heights.height, .hasAlpha = false, .rgba = {}};
    normals.rgba.reserve(heights.rgba.size());
    for (int y = 0; y < heights.height; ++y) {
        for (int x = 0; x < heights.width; ++x) {
            const float right = (heightAt(heights, x + 1, y) - heightAt(heights, x - 1, y)) * 0.5f;
            const float up = (heightAt(heights, x, y - 1) - heightAt(heights, x, y + 1)) * 0.5f;
            const glm::vec3 normal = glm::normalize(glm::vec3(-right, -up, 1.0f));
            for (int i = 0; i < 3; ++i) normals.rgba.push_back(asByte(normal[i]));
            normals.rgba.push_back(255);
        }
    }
    return normals;
}

}  // namespace walkcycle
