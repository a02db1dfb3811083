#include <cstddef>
#include <string>
#include <vector>

#include "loaders/AnimationText.h"
#include "loaders/CodeCases.h"

namespace walkcycle {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// What used to be taken, guessed or dropped without a word; and beside it what is legal and stays silent.

std::vector<Diagnostic> saidOf(const std::string& document) {
    return loadText(document).diagnostics;
}

auto isA(Severity severity, const char* code) {
    return AllOf(Field(&Diagnostic::severity, severity), Field(&Diagnostic::code, code));
}

std::string meshWithAccessor(const std::string& accessor) {
    return showing(
        "<library_geometries><geometry id='mesh'><mesh><source id='p'>"
        "<float_array id='a' count='9'>0 0 0 1 0 0 0 1 0</float_array><technique_common>" +
        accessor +
        "</technique_common></source>"
        "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>"
        "<triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2</p></triangles>"
        "</mesh></geometry></library_geometries>");
}

std::string slide(const AnimationText& animation) {
    return boxWith("<translate sid='t'>0 0 0</translate><rotate sid='r'>0 0 1 0</rotate>",
                   animations(animation.text()));
}

std::string skinOf(const std::string& instance) {
    return collada(
        triangle() +
        controllers(SkinText{.inverseBinds = matrixSource("binds", kIdentity + kIdentity)}.text()) +
        scene("<node id='hip' sid='hip' type='JOINT'><node id='knee' sid='knee' type='JOINT'/></node>"
              "<node id='body'><instance_controller url='#skin'>" +
              instance + "</instance_controller></node>"));
}

std::string morphOf(const std::string& method, const std::string& target) {
    return collada(
        triangle() + triangle("smile", target) +
        controllers("<controller id='morph'><morph source='#mesh'" + method + ">" +
                    nameSource("names", "smile", "IDREF_array") + floatSource("weights", "0", "W") +
                    "<targets><input semantic='MORPH_TARGET' source='#names'/>"
                    "<input semantic='MORPH_WEIGHT' source='#weights'/></targets></morph></controller>") +
        scene("<node id='n'><instance_controller url='#morph'/></node>"));
}

TEST(SilentSpotsTest, anAccessorThatSaysNoWidthIsWarnedOf) {
    EXPECT_THAT(saidOf(meshWithAccessor("<accessor source='#a' count='3'/>")),
                Contains(isA(Severity::Warning, "WC0205")));
    EXPECT_THAT(saidOf(meshWithAccessor("<accessor source='#a' count='3' stride='3'/>")), IsEmpty());
}

TEST(SilentSpotsTest, theDefaultStrideIsLegal) {
    const AnimationText plain{.target = "box/t.X", .times = "0 1", .values = "0 1"};
    std::string document = slide(plain);
    for (std::size_t at; (at = document.find(" stride=\"1\"")) != std::string::npos;) document.erase(at, 11);
    EXPECT_THAT(saidOf(document), IsEmpty());
}

TEST(SilentSpotsTest, anInputWithoutASemanticIsAnError) {
    EXPECT_THAT(saidOf(meshOf("<triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/>"
                              "<input source='#p' offset='0'/><p>0 1 2</p></triangles>")),
                ElementsAre(isA(Severity::Error, "WC0202")));
}

TEST(SilentSpotsTest, aSamplerThatGivesMoreThanItsTargetTakesIsWarnedOf) {
    const AnimationText wide{.target = "box/r.ANGLE", .times = "0 1", .values = "0 0 90 90", .params = "XY"};
    EXPECT_THAT(saidOf(slide(wide)), ElementsAre(isA(Severity::Warning, "WC0306")));
    const AnimationText whole{
        .target = "box/r.ANGLE", .times = "0 1", .values = "0 0 1 0 0 0 1 90", .params = "XYZW"};
    EXPECT_THAT(saidOf(slide(whole)), IsEmpty()) << "the part of a whole <rotate>";
}

TEST(SilentSpotsTest, aStrideThatWasForgottenIsSaid) {
    const AnimationText forgotten{.target = "box/t", .times = "0 1", .values = "0 0 0 1 1 1"};
    EXPECT_THAT(saidOf(slide(forgotten)), Contains(isA(Severity::Info, "WC0306")));
}

TEST(SilentSpotsTest, aSkinWithoutASkeletonIsLegal) {
    EXPECT_THAT(saidOf(skinOf("")), Not(Contains(Field(&Diagnostic::severity, Severity::Error))));
    EXPECT_THAT(codes(saidOf(skinOf(""))), Not(Contains("WC0413")));
}

TEST(SilentSpotsTest, aMorphTargetMayBeLongerThanTheMeshButNotShorter) {
    EXPECT_THAT(saidOf(morphOf("", "0 0 0 1 0 0 0 1 0 5 5 5")), IsEmpty());
    EXPECT_THAT(codes(saidOf(morphOf("", "0 0 0 1 0 0"))), Contains("WC0416"));
}

TEST(SilentSpotsTest, aMorphsMethodThatIsNoneIsWarnedOf) {
    EXPECT_THAT(saidOf(morphOf(" method='RELATIVE'", "0 0 0 1 0 0 0 1 0")), IsEmpty());
    EXPECT_THAT(saidOf(morphOf(" method='RELATVE'", "0 0 0 1 0 0 0 1 0")),
                ElementsAre(AllOf(isA(Severity::Warning, "WC0610"),
                                  Field(&Diagnostic::message, HasSubstr("perhaps 'RELATIVE' is meant")))));
}

}  // namespace
}  // namespace walkcycle
