#include <cstdlib>
#include <utility>

#include <epoxy/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "walkcycle/platform/HeadlessContext.h"
#include "walkcycle/platform/NoGraphicsDevice.h"

namespace walkcycle {
namespace {

int openGlVersion() {
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    return major * 10 + minor;
}

TEST(HeadlessContextTest, givesOpenGl33WithoutADisplay) {
    HeadlessContext context;
    EXPECT_GE(openGlVersion(), 33);
}

TEST(HeadlessContextTest, saysWhichDeviceItTookAndWhichOpenGl) {
    HeadlessContext context;
    EXPECT_THAT(context.description(), testing::HasSubstr("EGL"));
    EXPECT_THAT(context.description(), testing::HasSubstr("OpenGL "));
}

TEST(HeadlessContextTest, takesThePlatformThatTheEnvironmentNames) {
    setenv("EGL_PLATFORM", "surfaceless", 1);
    HeadlessContext context;
    unsetenv("EGL_PLATFORM");
    EXPECT_THAT(context.description(), testing::HasSubstr("surfaceless"));
}

TEST(HeadlessContextTest, isStillCurrentAfterItMoved) {
    HeadlessContext first;
    HeadlessContext second(std::move(first));
    second.makeCurrent();
    EXPECT_GE(openGlVersion(), 33);
}

TEST(HeadlessContextTest, livesOnWhenAnotherOneOfTheSameDeviceEnds) {
    HeadlessContext first;
    { HeadlessContext second; }
    first.makeCurrent();
    EXPECT_GE(openGlVersion(), 33);
}

}  // namespace
}  // namespace walkcycle
