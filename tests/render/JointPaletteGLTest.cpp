#include <vector>

#include "render/GlTest.h"
#include "render/JointPalette.h"

namespace walkcycle {
namespace {

class JointPaletteGLTest : public GlTest {};

TEST_F(JointPaletteGLTest, palettesFollowEachOtherOnAPage) {
    JointPalette palette;
    const std::vector<glm::mat4> ten(10, glm::mat4(1.0f));
    EXPECT_EQ(palette.add(ten).firstJoint, 0);
    EXPECT_EQ(palette.add(ten).firstJoint, 10);
    EXPECT_EQ(palette.pageCount(), 1u);
}

TEST_F(JointPaletteGLTest, aFullPageIsFollowedByAnother) {
    JointPalette palette(45);  // texels: fifteen joints
    const std::vector<glm::mat4> ten(10, glm::mat4(1.0f));
    EXPECT_EQ(palette.add(ten).page, 0u);
    const auto second = palette.add(ten);
    EXPECT_EQ(second.page, 1u);
    EXPECT_EQ(second.firstJoint, 0);
}

TEST_F(JointPaletteGLTest, clearingStartsAgain) {
    JointPalette palette;
    palette.add(std::vector<glm::mat4>(10, glm::mat4(1.0f)));
    palette.clear();
    EXPECT_EQ(palette.add(std::vector<glm::mat4>(10, glm::mat4(1.0f))).firstJoint, 0);
}

}  // namespace
}  // namespace walkcycle
