#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "walkcycle/platform/NoGraphicsDevice.h"
#include "walkcycle/platform/Window.h"

namespace walkcycle {
namespace {

// What a window does is tried where there is a display, by the viewer's test.
TEST(WindowTest, withoutADisplaySaysSoInOneLine) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    try {
        Window window("nowhere", 64, 64);
        FAIL() << "there is no display, but a window";
    } catch (const NoGraphicsDevice& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("display"));
        EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n")));
    }
}

}  // namespace
}  // namespace walkcycle
