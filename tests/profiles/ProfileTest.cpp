#include <set>

#include "ProfileCase.h"
#include "loaders/Diagnostics.h"
#include "profiles/Profile.h"

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
}

TEST(ProfileTest, codesFromAThousandOnHaveFourDigits) {
    EXPECT_STREQ(info(Code::GltfManyInfluences).id, "WC1001");
    EXPECT_STREQ(info(Code::IndexOutOfRange).id, "WC0301");
}

}  // namespace
}  // namespace walkcycle
