#include <cstddef>
#include <cstdint>
#include <string>

#include "loaders/LoadText.h"
#include "loaders/controllers/SkinLoader.h"

namespace walkcycle {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

// The armature is not identity: hip stands at (1, 0, 1), knee at (2, 0, 1), and the skin's node at (0, 5, 0).
const std::string kRig =
    "<node id='armature'><translate>0 0 1</translate>"
    "<node id='hip' sid='hip' type='JOINT'><translate>1 0 0</translate>"
    "<node id='knee' sid='knee' type='JOINT'><translate>1 0 0</translate></node></node></node>\n";

std::string bodyNode(const std::string& skeletons = "<skeleton>#hip</skeleton>",
                     const std::string& skin = "#skin") {
    return "<node id='body' name='Body'><translate>0 5 0</translate><instance_controller url='" + skin +
           "'>" + skeletons + "</instance_controller></node>\n";
}

std::string document(const SkinText& skin, const std::string& nodes = kRig + bodyNode()) {
    return collada(triangle() + controllers(skin.text()) + scene(nodes));
}

// A matrix as the file writes it, row by row.
std::string moved(float x, float y, float z) {
    return "1 0 0 " + std::to_string(x) + " 0 1 0 " + std::to_string(y) + " 0 0 1 " + std::to_string(z) +
           " 0 0 0 1 ";
}

// The triangle's corners follow hip, knee and knee; both inverse bind matrices are identity.
SkinText plainSkin() {
    SkinText skin;
    skin.inverseBinds = matrixSource("binds", kIdentity + kIdentity);
    return skin;
}

TEST(SkinLoaderTest, jointsCarryTheMeshWhereverItsOwnNodeStands) {
    const Model model = loadText(document(plainSkin()));
    EXPECT_THAT(posed(model), ElementsAre(isAt(1, 0, 1), isAt(3, 0, 1), isAt(2, 1, 1)));
    EXPECT_THAT(model.diagnostics, IsEmpty());
}

TEST(SkinLoaderTest, theInverseBindMatrixComesAfterTheBindShapeMatrix) {
    SkinText skin = plainSkin();
    skin.bindShape = "<bind_shape_matrix>0 -1 0 10  1 0 0 0  0 0 1 0  0 0 0 1</bind_shape_matrix>\n";
    skin.inverseBinds = matrixSource("binds", "2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 " + moved(-2, 0, -1));
    // (1,0,0) -> bind shape (10,1,0) -> inverse bind of knee (8,1,-1) -> knee (10,1,0)
    EXPECT_THAT(posed(loadText(document(skin))), ElementsAre(isAt(21, 0, 1), isAt(10, 1, 0), isAt(9, 0, 0)));
}

// 3 * 4,000,000.25 - 12,000,000; a float cannot hold the first product.
TEST(SkinLoaderTest, bindMatricesFarFromTheOriginLoseNothingWhenTheyAreMultiplied) {
    SkinText skin = plainSkin();
    skin.bindShape = "<bind_shape_matrix>" + moved(4000000.25f, 0, 0) + "</bind_shape_matrix>";
    skin.inverseBinds = matrixSource("binds", kIdentity + "3 0 0 -12000000 0 1 0 0 0 0 1 0 0 0 0 1");
    const Model model = loadText(document(skin));
    EXPECT_EQ(model.skins.at(0).bindMatrices.at(1)[3].x, 0.75f);
}

TEST(SkinLoaderTest, weightsThatCountThroughAnotherListOfJointsAreToldOf) {
    std::string text = document(plainSkin());
    const std::size_t weights = text.find("<vertex_weights");
    text.insert(weights, nameSource("others", "knee hip"));
    const std::size_t joint = text.find("#joints", text.find("<vertex_weights"));
    text.replace(joint, std::string("#joints").size(), "#others");
    const Model model = loadText(text);
    EXPECT_THAT(posed(model), ElementsAre(isAt(1, 0, 1), isAt(3, 0, 1), isAt(2, 1, 1)));
    ASSERT_THAT(codes(model.diagnostics), ElementsAre("WC0417"));
    EXPECT_EQ(model.diagnostics[0].line, lineOf(text, "<vertex_weights"));
}

TEST(SkinLoaderTest, theSkinsJointOrderIsItsOwn) {
    SkinText skin = plainSkin();
    skin.joints = nameSource("joints", "knee hip");
    EXPECT_THAT(posed(loadText(document(skin))), ElementsAre(isAt(2, 0, 1), isAt(2, 0, 1), isAt(1, 1, 1)));
}

TEST(SkinLoaderTest, jointsAreNamedBySidOrById) {
    SkinText skin = plainSkin();
    const std::string rig =
        "<node id='knee' sid='hip'><translate>7 0 0</translate></node>"
        "<node id='hip' sid='knee'><translate>0 7 0</translate></node>\n";
    EXPECT_THAT(posed(loadText(document(skin, rig + bodyNode("")))), Contains(isAt(7, 0, 0)));
    skin.joints = nameSource("joints", "hip knee", "IDREF_array");
    EXPECT_THAT(posed(loadText(document(skin, rig + bodyNode("")))), Contains(isAt(0, 7, 0)));
}

TEST(SkinLoaderTest, jointMinusOneAndVerticesWithoutWeightStayWithTheNode) {
    SkinText skin = plainSkin();
    skin.bindShape = "<bind_shape_matrix>" + moved(0, 0, 3) + "</bind_shape_matrix>";
    skin.vcount = "1 0 1";
    skin.v = "-1 0 1 0";
    EXPECT_THAT(posed(loadText(document(skin))), ElementsAre(isAt(0, 5, 3), isAt(1, 5, 3), isAt(2, 1, 4)));
}

TEST(SkinLoaderTest, withoutInverseBindMatricesTheRestPoseIsTheBindPose) {
    const std::string text = document(SkinText{});
    const Model model = loadText(text);
    EXPECT_THAT(posed(model), ElementsAre(isAt(0, 0, 0), isAt(1, 0, 0), isAt(0, 1, 0)));
    EXPECT_THAT(model.diagnostics,
                ElementsAre(says("WC0405", lineOf(text, "<joints>"),
                                 "COLLADA/library_controllers/controller[id=skin]/skin/joints")));
}

TEST(SkinLoaderTest, fewerInverseBindMatricesThanJointsIsAnError) {
    SkinText skin = plainSkin();
    skin.inverseBinds = matrixSource("binds", kIdentity);
    const std::string text = document(skin);
    EXPECT_THAT(loadText(text).diagnostics,
                ElementsAre(says("WC0404", lineOf(text, "<joints>"),
                                 "COLLADA/library_controllers/controller[id=skin]/skin/joints")));
}

TEST(SkinLoaderTest, aJointThatIsNotThereIsAnErrorAndItsVerticesStayWithTheNode) {
    SkinText skin = plainSkin();
    skin.joints = nameSource("joints", "hip ankle");
    const std::string text = document(skin);
    const Model model = loadText(text);
    EXPECT_THAT(posed(model), ElementsAre(isAt(1, 0, 1), isAt(1, 5, 0), isAt(0, 6, 0)));
    EXPECT_THAT(model.diagnostics, ElementsAre(says("WC0401", lineOf(text, "hip ankle"),
                                                    "COLLADA/library_controllers/controller[id=skin]/skin/"
                                                    "source[id=joints]/Name_array[id=joints-array]")));
    EXPECT_THAT(model.diagnostics[0].message, testing::HasSubstr("'ankle'"));
}

TEST(SkinLoaderTest, oneNameTwiceIsAWarning) {
    SkinText skin = plainSkin();
    skin.joints = nameSource("joints", "hip hip");
    EXPECT_THAT(codes(loadText(document(skin)).diagnostics), ElementsAre("WC0407"));
}

TEST(SkinLoaderTest, matricesThatFlattenTheMeshAreAWarning) {
    SkinText skin = plainSkin();
    skin.bindShape = "<bind_shape_matrix>1 0 0 0 0 0 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>";
    skin.inverseBinds = matrixSource("binds", kIdentity + "0 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
    EXPECT_THAT(codes(loadText(document(skin)).diagnostics), ElementsAre("WC0411", "WC0411"));
}

TEST(SkinLoaderTest, aSmallUnitIsNotSingular) {
    SkinText skin = plainSkin();
    skin.bindShape = "<bind_shape_matrix>1e-5 0 0 0 0 1e-5 0 0 0 0 1e-5 0 0 0 0 1</bind_shape_matrix>";
    EXPECT_THAT(loadText(document(skin)).diagnostics, IsEmpty());
}

TEST(SkinLoaderTest, aBindShapeMatrixOfFifteenNumbersIsAnErrorAndTakenAsIdentity) {
    SkinText skin = plainSkin();
    skin.bindShape = "<bind_shape_matrix>2 0 0 0 0 2 0 0 0 0 2 0 0 0 0</bind_shape_matrix>";
    const std::string text = document(skin);
    const Model model = loadText(text);
    EXPECT_THAT(posed(model)[1], isAt(3, 0, 1));
    EXPECT_THAT(model.diagnostics,
                ElementsAre(says("WC0205", lineOf(text, "<bind_shape"),
                                 "COLLADA/library_controllers/controller[id=skin]/skin/bind_shape_matrix")));
}

TEST(SkinLoaderTest, theLastRowOfAMatrixIsAlways0001) {
    SkinText skin = plainSkin();
    skin.bindShape = "<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 5 5 5 7</bind_shape_matrix>";
    EXPECT_THAT(posed(loadText(document(skin)))[1], isAt(3, 0, 1));
}

TEST(SkinLoaderTest, aSkinWithoutWeightsOrJointsIsDrawnUnskinnedWithAnError) {
    for (const char* element : {"joints", "vertex_weights"}) {
        std::string text = document(plainSkin());
        const std::string open = std::string("<") + element, close = std::string("</") + element + ">";
        const std::size_t begin = text.find(open + (*element == 'j' ? ">" : " "));
        text.erase(begin, text.find(close) + close.size() - begin);
        const Model model = loadText(text);
        EXPECT_THAT(model.diagnostics,
                    ElementsAre(says("WC0203", lineOf(text, "<skin"),
                                     "COLLADA/library_controllers/controller[id=skin]/skin")));
        EXPECT_THAT(model.instances.at(0).deformers, IsEmpty());
        EXPECT_THAT(posed(model)[1], isAt(1, 5, 0));
    }
}

TEST(SkinLoaderTest, severalSkinsMayHangOnOneSkeleton) {
    SkinText first = plainSkin(), second = plainSkin();
    second.id = "second";
    second.joints = second.weights = second.inverseBinds = "";
    std::string secondText = second.text();
    secondText.insert(secondText.find("<input semantic=\"JOINT\" source=\"#joints\"/>"),
                      "<input semantic=\"INV_BIND_MATRIX\" source=\"#binds\"/>");
    const Model model =
        loadText(collada(triangle() + controllers(first.text() + secondText) +
                         scene(kRig + bodyNode() + bodyNode("<skeleton>#hip</skeleton>", "#second"))));
    ASSERT_EQ(model.skins.size(), 2u);
    EXPECT_EQ(model.skins[0].joints[1], model.skins[1].joints[1]);
    EXPECT_THAT(posed(model, 0, 1), ElementsAre(isAt(1, 0, 1), isAt(3, 0, 1), isAt(2, 1, 1)));
}

TEST(SkinLoaderTest, oneSkinMayHangOnSeveralSkeletons) {
    const std::string two =
        "<node id='left'><translate>9 0 0</translate><node sid='hip'/><node sid='knee'/></node>"
        "<node id='right'><translate>0 9 0</translate><node sid='hip'/><node sid='knee'/></node>\n";
    const Model model = loadText(document(
        plainSkin(), two + bodyNode("<skeleton>#left</skeleton>") + bodyNode("<skeleton>#right</skeleton>")));
    EXPECT_THAT(posed(model, 0, 0)[0], isAt(9, 0, 0));
    EXPECT_THAT(posed(model, 0, 1)[0], isAt(0, 9, 0));
    EXPECT_EQ(model.influences.size(), 1u) << "what the file says once is kept once";
    EXPECT_EQ(model.meshes.size(), 1u);
}

TEST(SkinLoaderTest, jointsInTheLibraryAloneMoveTheSkinUndrawn) {
    SkinText skin = plainSkin();
    const std::string library =
        "<library_nodes><node id='rig'><translate>4 0 0</translate><node sid='hip'/>"
        "<node sid='knee'><instance_geometry url='#mesh'/></node></node></library_nodes>\n";
    const Model model = loadText(collada(triangle() + library + controllers(skin.text()) +
                                         scene(bodyNode("<skeleton>#rig</skeleton>"))));
    EXPECT_THAT(posed(model)[0], isAt(4, 0, 0));
    EXPECT_EQ(model.instances.size(), 1u);
}

TEST(SkinLoaderTest, theNodePlacesTheSkinWhereTheExporterMeansItOrTheUserAsks) {
    const std::string plain = document(plainSkin());
    std::string maya = plain;
    maya.insert(maya.find("<unit"),
                "<contributor><authoring_tool>Maya 8.5 | ColladaMaya v3.03</authoring_tool></contributor>");
    LoadOptions apply, ignore;
    apply.skinNode = SkinNode::Apply;
    ignore.skinNode = SkinNode::Ignore;
    EXPECT_THAT(posed(loadText(plain))[0], isAt(1, 0, 1));
    EXPECT_THAT(posed(loadText(plain, apply))[0], isAt(1, 5, 1));
    EXPECT_THAT(posed(loadText(maya))[0], isAt(1, 5, 1));
    EXPECT_THAT(posed(loadText(maya, ignore))[0], isAt(1, 0, 1));
    EXPECT_THAT(codes(loadText(maya).diagnostics), ElementsAre("WC0406"));
}

TEST(SkinLoaderTest, onlyWhatLiesBetweenTheNodeAndTheJointsIsAppliedOnTop) {
    const std::string together =
        "<node id='all'><translate>100 0 0</translate>" + kRig + bodyNode() + "</node>";
    LoadOptions apply;
    apply.skinNode = SkinNode::Apply;
    EXPECT_THAT(posed(loadText(document(plainSkin(), together), apply))[0], isAt(101, 5, 1));
}

TEST(SkinLoaderTest, theLimitOfJointsOfAllSkinsHoldsAtItsJoint) {
    const std::string text = document(plainSkin(), kRig + bodyNode() + bodyNode());
    LoadOptions options;
    for (const std::uint64_t limit : {7u, 6u}) {  // two skins of two joints and their node
        options.limits.maxSkinJoints = limit;
        EXPECT_EQ(loadText(text, options).skins.size(), 2u);
    }
    options.limits.maxSkinJoints = 5;
    EXPECT_EQ(whyNot(text, options).code, "WC0801");
}

}  // namespace
}  // namespace walkcycle
