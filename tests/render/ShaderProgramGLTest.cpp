#include <gmock/gmock.h>

#include "render/GlTest.h"
#include "render/ShaderProgram.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class ShaderProgramGLTest : public GlTest {};

TEST_F(ShaderProgramGLTest, aShaderThatDoesNotCompileIsNamedWithTheDriversReason) {
    EXPECT_THAT(
        [] {
            ShaderProgram({.vertex = {"overlayVertex"}, .fragment = {"flatFragment"}},
                          "#error out of order\n");
        },
        ThrowsMessage<GraphicsError>(AllOf(HasSubstr("overlayVertex"), HasSubstr("out of order"))));
}

TEST_F(ShaderProgramGLTest, aProgramThatDoesNotLinkSaysSo) {
    EXPECT_THAT(
        [] {
            const char* const missing = "noSuchOutput";
            ShaderProgram({.vertex = {"overlayVertex"}, .fragment = {"flatFragment"}}, "", {&missing, 1});
        },
        ThrowsMessage<GraphicsError>(HasSubstr("does not link")));
}

}  // namespace
}  // namespace walkcycle
