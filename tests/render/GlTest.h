#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "walkcycle/io/File.h"
#include "walkcycle/io/Image.h"
#include "walkcycle/platform/HeadlessContext.h"

namespace walkcycle {

// A test that draws: without a display, never skipped. All of them share a context.
class GlTest : public testing::Test {
protected:
    static void SetUpTestSuite() { static HeadlessContext context; }

    // With WALKCYCLE_PICTURES=folder set, what the tests draw can be looked at.
    static void keep(const Image& image, const std::string& name) {
        const char* folder = std::getenv("WALKCYCLE_PICTURES");
        if (folder) writeFile(std::string(folder) + "/" + name + ".png", encodePng(image));
    }
};

inline std::array<int, 4> pixel(const Image& image, int x, int y) {
    const std::size_t at =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
        4;
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

}  // namespace walkcycle
