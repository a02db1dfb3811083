#include <string>
#include <vector>

#include "ProfileCase.h"

namespace walkcycle {
namespace {

using testing::IsEmpty;

void expectGazebo(const std::vector<Change>& changes, const char* code, const std::string& marker,
                  const char* pathEnd) {
    expectSaid(Profile::Gazebo, changed(changes), code, marker, pathEnd);
}

const std::string kImage =
    "<library_images>\n<image id=\"map\"><init_from>my%20skin.png</init_from></image></library_images>\n"
    "  <library_effects>";
const std::string kTransparent = "<transparent><color>1 1 1 0.5</color></transparent>";

TEST(GazeboMaterialRulesTest, aConstantMaterialIsGrey) {
    expectGazebo({{kLambert, "<constant><emission><color>1 0 0 1</color></emission></constant>\n"}}, "WC1044",
                 "<constant>", "technique[sid=common]/constant");
}

TEST(GazeboMaterialRulesTest, anEmissionPictureIsNotShown) {
    expectGazebo(
        {{kLambert, "<lambert><emission>\n<texture texture=\"map\" texcoord=\"uv\"/></emission></lambert>"},
         {"  <library_effects>",
          "<library_images><image id=\"map\"><init_from>a.png</init_from></image>"
          "</library_images>\n  <library_effects>"}},
        "WC1045", "<texture ", "emission/texture");
}

TEST(GazeboMaterialRulesTest, transparencyNeedsItsMode) {
    expectGazebo({{"</diffuse>\n", "</diffuse>\n" + kTransparent + "\n"}}, "WC1046", "<transparent>",
                 "lambert/transparent");
}

TEST(GazeboMaterialRulesTest, transparencyWithItsModeAndOpaqueMaterialsAreFine) {
    EXPECT_THAT(
        said(Profile::Gazebo,
             changed(
                 {{"</diffuse>\n",
                   "</diffuse>\n<transparent opaque=\"A_ONE\"><color>1 1 1 0.5</color></transparent>\n"}})),
        IsEmpty());
    EXPECT_THAT(
        said(Profile::Gazebo,
             changed({{"</diffuse>\n", "</diffuse>\n<transparent><color>1 1 1 1</color></transparent>\n"}})),
        IsEmpty());
}

TEST(GazeboMaterialRulesTest, escapesInNamesOfPicturesAreNotDecoded) {
    expectGazebo({{"  <library_effects>", kImage}}, "WC1047", "<init_from>", "image[id=map]/init_from");
}

}  // namespace
}  // namespace walkcycle
