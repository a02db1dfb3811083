#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include "ProfileCase.h"
#include "loaders/document/Diagnostics.h"
#include "walkcycle/profiles/Profile.h"

namespace walkcycle {
namespace {

using testing::IsEmpty;

TEST(ProfileTest, aCleanDocumentIsCleanForEveryTarget) {
    const std::size_t animations = cleanDocument().find("  <library_animations>");
    const std::string end = "</library_animations>\n";
    std::string still = cleanDocument();
    still.erase(animations, still.find(end) + end.size() - animations);
    EXPECT_THAT(said(Profile::Gltf, cleanDocument()), IsEmpty());
    EXPECT_THAT(said(Profile::Gazebo, cleanDocument()), IsEmpty());
    EXPECT_THAT(said(Profile::SecondLife, still),
                IsEmpty());  // which takes animations from files of their own
    EXPECT_THAT(said(Profile::ThinMatrix, cleanDocument()), IsEmpty());
}

TEST(ProfileTest, targetsAreCalledByTheirNames) {
    EXPECT_EQ(profileNamed("secondlife"), Profile::SecondLife);
    EXPECT_EQ(profileNamed("thinmatrix"), Profile::ThinMatrix);
    EXPECT_FALSE(profileNamed("unity"));
    for (const std::string_view name : profileNames()) EXPECT_TRUE(profileNamed(name)) << name;
    EXPECT_EQ(profileNames().size(), 4u);
}

// Whatever is wrong with a document, its rules can be asked.
TEST(ProfileTest, damageDoesNoHarm) {
    const Change damages[] = {
        {"source=\"#body-normals\" offset=\"1\"", "source=\"#body-normals\" offset=\"2147483647\""},
        {"<vcount>3 3</vcount>", "<vcount>3 -2147483648</vcount>"},
        {"<vcount>1 1 2 1</vcount>", "<vcount>1 9 -5</vcount>"},
        {"stride=\"3\"", "stride=\"0\""},
        {"<matrix sid=\"transform\">1 0 0 0", "<matrix sid=\"transform\">1e200 1e300 NaN"},
        {"<skin source=\"#body-mesh\">", "<skin source=\"#body-skin\">"},
        {"mPelvis mTorso</Name_array>", "</Name_array>"},
        {"target=\"mTorso/transform\"", "target=\"\""},
        {"<float_array id=\"mPelvis-times-array\" count=\"2\">0 1</float_array>", ""}};
    for (const Change& damage : damages)
        for (const std::string_view name : profileNames())
            EXPECT_NO_THROW(said(*profileNamed(name), changed({damage}))) << damage.to;
}

TEST(ProfileTest, codesFromAThousandOnHaveFourDigits) {
    EXPECT_STREQ(info(Code::GltfManyInfluences).id, "WC1001");
    EXPECT_STREQ(info(Code::IndexOutOfRange).id, "WC0301");
}

}  // namespace
}  // namespace walkcycle
