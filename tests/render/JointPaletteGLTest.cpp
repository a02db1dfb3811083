#include <vector>

#include "render/GlTest.h"
#include "render/JointPalette.h"

namespace walkcycle {
namespace {

class JointPaletteGLTest : public GlTest {};

TEST_F(JointPaletteGLTest, palettesFollowEachOtherOnAPage) {
    JointPalette palette;
    EXPECT_EQ(palette.add(10).firstJoint, 0u);
    EXPECT_EQ(palette.add(10).firstJoint, 10u);
    EXPECT_EQ(palette.pageCount(), 1u);
}

TEST_F(JointPaletteGLTest, aFullPageIsFollowedByAnother) {
    JointPalette palette(45);  // texels: fifteen joints
    EXPECT_EQ(palette.add(10).page, 0u);
    const JointPalette::Range second = palette.add(10);
    EXPECT_EQ(second.page, 1u);
    EXPECT_EQ(second.firstJoint, 0u);
}

TEST_F(JointPaletteGLTest, clearingStartsAgain) {
    JointPalette palette;
    palette.add(10);
    palette.clear();
    EXPECT_EQ(palette.add(10).firstJoint, 0u);
}

TEST_F(JointPaletteGLTest, whatIsWrittenIntoAPaletteIsWhatTheShaderReads) {
    JointPalette palette;
    palette.add(7);
    palette.clear();  // a shorter picture after a longer one
    const JointPalette::Range first = palette.add(1), second = palette.add(2);
    palette.joints(first)[0].rows[0].x = 5.0f;
    palette.joints(second)[1].rows[2].w = 9.0f;
    palette.upload();  // leaves the buffer bound

    std::vector<JointRows> rows(3);
    glGetBufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(3 * sizeof(JointRows)), rows.data());
    EXPECT_EQ(rows[0].rows[0].x, 5.0f);
    EXPECT_EQ(rows[2].rows[2].w, 9.0f);
}

}  // namespace
}  // namespace walkcycle
