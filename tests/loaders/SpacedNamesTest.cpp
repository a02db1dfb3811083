#include <gmock/gmock.h>

#include "loaders/LoadText.h"
#include "loaders/SpacedNames.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Model spacedSkin(const std::string& count) {
    SkinText skin;
    skin.joints = nameSource("joints", "Bip01 L Thigh Bip01 L Calf");
    const std::size_t at = skin.joints.find("count=\"6\"");
    skin.joints.replace(at, 9, "count=\"" + count + "\"");
    const std::size_t accessor = skin.joints.find("count=\"6\"");
    skin.joints.replace(accessor, 9, "count=\"" + count + "\"");
    skin.inverseBinds = matrixSource("binds", kIdentity + kIdentity);
    return loadText(collada(triangle() + controllers(skin.text()) +
                            scene("<node name='Bip01 L Thigh' sid='Bip01 L Thigh' type='JOINT'>"
                                  "<node name='Bip01 L Calf' sid='Bip01 L Calf' type='JOINT'/></node>"
                                  "<node id='n'><instance_controller url='#skin'/></node>")));
}

TEST(SpacedNamesTest, wordsBecomeTheNamesThatNodesHave) {
    const Model model = spacedSkin("2");

    EXPECT_THAT(model.diagnostics, IsEmpty());
    ASSERT_EQ(model.skins.size(), 1u);
    EXPECT_THAT(model.skins[0].joints, ElementsAre(0, 1, 2));  // the last one is the skin's own node
}

TEST(SpacedNamesTest, wordsThatMakeNoSuchNamesStayWords) {
    const Model model = spacedSkin("3");

    EXPECT_FALSE(model.diagnostics.empty());
}

}  // namespace
}  // namespace walkcycle
