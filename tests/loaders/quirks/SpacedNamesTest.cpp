#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/LoadText.h"
#include "loaders/quirks/SpacedNames.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;

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

    EXPECT_THAT(codes(model.diagnostics), ElementsAre("WC0120"));
    ASSERT_EQ(model.skins.size(), 1u);
    EXPECT_THAT(model.skins[0].joints, ElementsAre(0, 1, 2));  // the last one is the skin's own node
}

TEST(SpacedNamesTest, wordsThatMakeNoSuchNamesStayWords) {
    const Model model = spacedSkin("3");

    EXPECT_FALSE(model.diagnostics.empty());
}

std::vector<std::string_view> wordsOf(const std::string& text) {
    return splitWords(text);
}

TEST(SpacedNamesTest, onlyAsManyNamesAsTheCountSaysAreMade) {
    TestLoad load(
        "<COLLADA><library_nodes><node name='Left Leg'/><node sid='Left'/><node "
        "id='Arm'/></library_nodes></COLLADA>");
    const std::string three = "Left Leg Left Arm", odd = "Left Leg Tail Arm";
    EXPECT_EQ(joinSpacedNames(wordsOf(three), 3, load.collada),
              (std::vector<std::string>{"Left Leg", "Left", "Arm"}));
    EXPECT_FALSE(joinSpacedNames(wordsOf(three), 2, load.collada)) << "more names than the count";
    EXPECT_FALSE(joinSpacedNames(wordsOf(three), 4, load.collada)) << "each word is a name";
    EXPECT_FALSE(joinSpacedNames(wordsOf(three), 0, load.collada));
    EXPECT_FALSE(joinSpacedNames(wordsOf(odd), 3, load.collada)) << "no node is called Tail";
    std::string many;
    for (int i = 0; i < 20; ++i) many += "Arm ";
    EXPECT_FALSE(joinSpacedNames(wordsOf(many), 1, load.collada)) << "no name has so many words";
}

}  // namespace
}  // namespace walkcycle
