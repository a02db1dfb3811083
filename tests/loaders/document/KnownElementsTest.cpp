#include <cstddef>
#include <string>
#include <vector>

#include "loaders/CodeCases.h"

namespace walkcycle {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kTriangles =
    "<triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2</p></triangles>\n";

std::vector<Diagnostic> saidOf(const std::string& document) {
    return loadText(document).diagnostics;
}

TEST(KnownElementsTest, aMisspeltElementIsAWarningThatSaysWhatWasMeant) {
    const auto said = saidOf(meshOf(kTriangles + "<trinagles count='1'/>\n"));
    ASSERT_THAT(codes(said), ElementsAre("WC0212"));
    EXPECT_EQ(said[0].severity, Severity::Warning);
    EXPECT_EQ(said[0].message,
              "<trinagles> is not known in <mesh> and not read; perhaps <triangles> is meant");
}

TEST(KnownElementsTest, anElementInAWrongPlaceIsAWarning) {
    const auto said = saidOf(collada(scene("<node id='n'><triangles/></node>")));
    ASSERT_THAT(codes(said), ElementsAre("WC0212"));
    EXPECT_EQ(said[0].severity, Severity::Warning);
    EXPECT_EQ(said[0].message, "<triangles> is not known in <node> and not read");
}

TEST(KnownElementsTest, aNameThatTheFormatDoesNotKnowAtAllIsAnInfo) {
    const auto said = saidOf(collada(scene("<node id='n'><studio_notes/></node>")));
    ASSERT_THAT(codes(said), ElementsAre("WC0212"));
    EXPECT_EQ(said[0].severity, Severity::Info);
}

TEST(KnownElementsTest, whatProgramsMayFillAsTheyLikeIsLetAlone) {
    EXPECT_THAT(saidOf(collada("<extra><technique profile='X'><anything/></technique></extra>" +
                               scene("<node id='n'><extra><node/><trinagles/></extra></node>"))),
                IsEmpty());
    EXPECT_THAT(
        saidOf(meshOf("<source id='s'><technique profile='X'><anything/></technique></source>" + kTriangles)),
        IsEmpty());
    EXPECT_THAT(
        saidOf(collada(scene("<node id='n'><x:thing xmlns:x='urn:x'/><thing xmlns='urn:x'/></node>"))),
        IsEmpty());
}

TEST(KnownElementsTest, aPrefixForAllOfColladaChangesNothing) {
    std::string document = meshOf(kTriangles);
    for (std::size_t at = document.find('<', document.find("<COLLADA")); at != std::string::npos;
         at = document.find('<', at + 1))
        document.insert(at + (document[at + 1] == '/' ? 2 : 1), "c:");
    document.replace(document.find("xmlns="), 6, "xmlns:c=");
    const Model model = loadText(document);
    EXPECT_THAT(model.diagnostics, IsEmpty());
    ASSERT_THAT(model.meshes, SizeIs(1));
    EXPECT_THAT(model.meshes[0].indices, SizeIs(3));
}

TEST(KnownElementsTest, aPrefixIsNoHidingPlaceForASlip) {
    EXPECT_THAT(
        codes(saidOf("<c:COLLADA xmlns:c='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'>"
                     "<c:library_visual_scenes><c:visual_scene id='s'><c:nodes/></c:visual_scene>"
                     "</c:library_visual_scenes><c:scene><c:instance_visual_scene url='#s'/></c:scene>"
                     "</c:COLLADA>")),
        Contains("WC0212"));
}

TEST(KnownElementsTest, theSecondOfWhatMayStandOnceIsNamed) {
    const auto said = saidOf(meshOf("<vertices id='w'/>" + kTriangles));
    ASSERT_THAT(codes(said), ElementsAre("WC0213"));
    EXPECT_EQ(said[0].elementPath, "COLLADA/library_geometries/geometry[id=mesh]/mesh/vertices[id=w]");
}

TEST(KnownElementsTest, otherDocumentsAreLookedAtAsWell) {
    LoadOptions options;
    options.resolver = files({{"other.dae", meshOf(kTriangles + "<polylists/>")}});
    const Model model =
        loadText(collada(scene("<node id='n'><instance_geometry url='other.dae#mesh'/></node>")), options);
    ASSERT_THAT(codes(model.diagnostics), ElementsAre("WC0212"));
    EXPECT_EQ(model.diagnostics[0].file, "other.dae");
}

TEST(KnownElementsTest, manyOfThemAreCountedInOneWalk) {
    std::string odd;
    for (int i = 0; i < 20000; ++i) odd += "<o" + std::to_string(i) + "/>";
    const auto said = saidOf(collada(scene("<node id='n'>" + odd + "</node>")));
    EXPECT_LT(said.size(), 20u);
}

TEST(KnownElementsTest, wordsThatAreNoneAreNamed) {
    EXPECT_THAT(saidOf(collada(scene("<node id='n' type='JIONT'/>"))),
                Contains(testing::Field(&Diagnostic::message, HasSubstr("perhaps 'JOINT' is meant"))));
    const std::string input = "<input semantic='NORML' source='#p' offset='0'/>";
    const auto slip = saidOf(meshOf("<triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/>" +
                                    input + "<p>0 1 2</p></triangles>"));
    ASSERT_THAT(codes(slip), ElementsAre("WC0610"));
    EXPECT_EQ(slip[0].severity, Severity::Warning);
    EXPECT_THAT(slip[0].message, HasSubstr("perhaps 'NORMAL' is meant"));
}

TEST(KnownElementsTest, aSemanticOfAProgramsOwnIsAnInfo) {
    const auto own =
        saidOf(meshOf("<triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/>"
                      "<input semantic='STUDIO_HEAT' source='#p' offset='0'/><p>0 1 2</p></triangles>"));
    ASSERT_THAT(codes(own), ElementsAre("WC0610"));
    EXPECT_EQ(own[0].severity, Severity::Info);
}

}  // namespace
}  // namespace walkcycle
