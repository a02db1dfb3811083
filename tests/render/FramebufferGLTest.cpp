#include <array>
#include <stdexcept>

#include <epoxy/gl.h>

#include "render/GlTest.h"
#include "walkcycle/render/Framebuffer.h"

namespace walkcycle {
namespace {

class FramebufferGLTest : public GlTest {
protected:
    // A picture of which the lower half has been filled with a colour.
    static Image halfFilled(int samples, float alpha) {
        Framebuffer picture(8, 8, samples);
        glBindFramebuffer(GL_FRAMEBUFFER, picture.target().framebuffer);
        glEnable(GL_FRAMEBUFFER_SRGB);
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 8, 4);
        glClearColor(0.5f * alpha, 0.0f, 0.0f, alpha);
        glClear(GL_COLOR_BUFFER_BIT);
        glDisable(GL_SCISSOR_TEST);
        return picture.read();
    }
};

TEST_F(FramebufferGLTest, rowsComeFromTheTop) {
    const Image image = halfFilled(4, 1.0f);
    EXPECT_EQ(pixel(image, 3, 1)[3], 0);
    EXPECT_EQ(pixel(image, 3, 6)[3], 255);
}

TEST_F(FramebufferGLTest, givesSrgbOfTheLightThatWasDrawn) {
    for (const int samples : {1, 4})
        EXPECT_NEAR(pixel(halfFilled(samples, 1.0f), 3, 6)[0], 188, 1) << samples;
}

TEST_F(FramebufferGLTest, alphaIsStraightAndClearIsBlack) {
    const Image image = halfFilled(4, 0.25f);
    EXPECT_NEAR(pixel(image, 3, 6)[0], 188, 2);
    EXPECT_EQ(pixel(image, 3, 6)[3], 64);
    EXPECT_EQ(pixel(image, 3, 1), (std::array{0, 0, 0, 0}));
}

TEST_F(FramebufferGLTest, takesFewerSamplesWhereThereAreFewer) {
    EXPECT_LE(Framebuffer(4, 4, 1000).samples(), 64);
    EXPECT_EQ(Framebuffer(4, 4, 0).samples(), 1);
}

TEST_F(FramebufferGLTest, anImpossibleSizeIsRefusedInWords) {
    EXPECT_THROW(Framebuffer(0, 10), std::runtime_error);
    EXPECT_THROW(Framebuffer(1 << 24, 10), std::runtime_error);
}

}  // namespace
}  // namespace walkcycle
