#include <cstddef>
#include <string>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/controllers/ControllerLoader.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A morph of `source` whose targets are geometries (or controllers) by id.
std::string morph(const std::string& id, const std::string& source, const std::string& targets,
                  const std::string& weights, const std::string& attributes = "") {
    return "<controller id='" + id + "'><morph source='" + source + "' " + attributes + ">\n" +
           nameSource(id + "-names", targets, "IDREF_array") + floatSource(id + "-weights", weights, "W") +
           "<targets><input semantic='MORPH_TARGET' source='#" + id +
           "-names'/><input semantic='MORPH_WEIGHT' source='#" + id +
           "-weights'/></targets>\n</morph></controller>\n";
}

const std::string kMeshes =
    triangle() + triangle("high", "0 0 2 1 0 2 0 1 2") + triangle("wide", "0 0 0 3 0 0 0 1 0");

std::string nodes(const std::string& url) {
    return "<node id='hip' sid='hip'><translate>10 0 0</translate><node sid='knee'/></node>\n"
           "<node id='body'><instance_controller url='" +
           url + "'/></node>";
}

SkinText skinOf(const std::string& source) {
    SkinText skin;
    skin.source = source;
    skin.inverseBinds = matrixSource("binds", kIdentity + kIdentity);
    return skin;
}

std::vector<Deformer::Kind> kinds(const Model& model) {
    std::vector<Deformer::Kind> all;
    for (const Deformer& deformer : model.instances.at(0).deformers) all.push_back(deformer.kind);
    return all;
}

TEST(ControllerLoaderTest, skinOverMorphDeformsByMorphFirst) {
    const Model model = loadText(
        collada(kMeshes + controllers(skinOf("#smile").text() + morph("smile", "#mesh", "high", "0.5")) +
                scene(nodes("#skin"))));
    EXPECT_THAT(kinds(model), ElementsAre(Deformer::Kind::Morph, Deformer::Kind::Skin));
    EXPECT_THAT(posed(model), ElementsAre(isAt(10, 0, 1), isAt(11, 0, 1), isAt(10, 1, 1)));
    EXPECT_THAT(model.diagnostics, IsEmpty());
}

TEST(ControllerLoaderTest, morphOverSkinDeformsBySkinFirst) {
    const Model model = loadText(
        collada(kMeshes + controllers(skinOf("#mesh").text() + morph("smile", "#skin", "high", "0.5")) +
                scene(nodes("#smile"))));
    EXPECT_THAT(kinds(model), ElementsAre(Deformer::Kind::Skin, Deformer::Kind::Morph));
    EXPECT_EQ(model.instances[0].sourceUrl, "#smile");
    EXPECT_THAT(model.diagnostics, IsEmpty());
}

TEST(ControllerLoaderTest, morphOverMorphKeepsTheInnerOneFirst) {
    const Model model =
        loadText(collada(kMeshes +
                         controllers(morph("outer", "#inner", "wide", "0.25", "method='RELATIVE'") +
                                     morph("inner", "#mesh", "high", "1")) +
                         scene(nodes("#outer"))));
    ASSERT_THAT(kinds(model), ElementsAre(Deformer::Kind::Morph, Deformer::Kind::Morph));
    EXPECT_EQ(model.morphs[static_cast<std::size_t>(model.instances[0].deformers[0].index)].id, "inner");
    EXPECT_EQ(model.morphs[static_cast<std::size_t>(model.instances[0].deformers[1].index)].method,
              MorphMethod::Relative);
    EXPECT_THAT(posed(model)[1], isAt(1.75f, 0, 2));
}

TEST(ControllerLoaderTest, aMorphsWeightsAreParametersWhereverItIsInstanced) {
    const Model model =
        loadText(collada(kMeshes + controllers(morph("smile", "#mesh", "high wide", "0.5 0.25")) +
                         scene(nodes("#smile") + "<node><instance_controller url='#smile'/></node>")));
    ASSERT_EQ(model.morphs.size(), 1u);
    ASSERT_EQ(model.parameters.size(), 2u);
    EXPECT_EQ(model.parameters[1].restValue, 0.25f);
    EXPECT_EQ(model.parameters[1].component, 1);
    EXPECT_EQ(model.instances.size(), 2u);
}

TEST(ControllerLoaderTest, aTargetMayBeAControllerWhoseShapeIsMeant) {
    SkinText skin = skinOf("#high");
    const Model model = loadText(collada(
        kMeshes + controllers(skin.text() + morph("smile", "#mesh", "skin", "1")) + scene(nodes("#smile"))));
    EXPECT_THAT(posed(model)[0], isAt(0, 0, 2));
    EXPECT_THAT(model.diagnostics, IsEmpty());
}

TEST(ControllerLoaderTest, aTargetThatIsNotThereMovesNothingUnderEitherMethod) {
    for (const char* method : {"method='NORMALIZED'", "method='RELATIVE'"}) {
        const std::string text = collada(kMeshes + controllers(morph("smile", "#mesh", "gone", "1", method)) +
                                         scene(nodes("#smile")));
        const Model model = loadText(text);
        EXPECT_THAT(posed(model), ElementsAre(isAt(0, 0, 0), isAt(1, 0, 0), isAt(0, 1, 0))) << method;
        EXPECT_THAT(
            model.diagnostics,
            ElementsAre(says("WC0201", lineOf(text, "<IDREF_array id=\"smile-names"),
                             "COLLADA/library_controllers/controller[id=smile]/morph/source[id=smile-names]/"
                             "IDREF_array[id=smile-names-array]")));
    }
}

TEST(ControllerLoaderTest, targetsAndWeightsThatDifferInNumberAreReported) {
    const Model model = loadText(
        collada(kMeshes + controllers(morph("smile", "#mesh", "high wide", "1")) + scene(nodes("#smile"))));
    EXPECT_EQ(model.morphs.at(0).targets.size(), 2u);
    EXPECT_EQ(model.parameters.size(), 2u);
    EXPECT_EQ(model.diagnostics.size(), 1u);
}

TEST(ControllerLoaderTest, controllersThatLeadBackToThemselvesAreAnError) {
    const std::string text =
        collada(kMeshes + controllers(morph("a", "#b", "high", "1") + morph("b", "#a", "high", "1")) +
                scene(nodes("#a")));
    const Model model = loadText(text);
    EXPECT_THAT(model.instances, IsEmpty());
    EXPECT_THAT(model.diagnostics, ElementsAre(says("WC0206", lineOf(text, "<controller id='a'"),
                                                    "COLLADA/library_controllers/controller[id=a]")));
}

TEST(ControllerLoaderTest, anEmptyControllerIsAnError) {
    const std::string text =
        collada(kMeshes + controllers("<controller id='skin'/>") + scene(nodes("#skin")));
    const Model model = loadText(text);
    EXPECT_THAT(model.instances, IsEmpty());
    EXPECT_THAT(model.diagnostics.at(0).line, lineOf(text, "<controller id"));
}

TEST(ControllerLoaderTest, aReferenceToWhatIsNoControllerIsAnErrorWhereItStands) {
    const std::string text = collada(kMeshes + scene(nodes("#hip")));
    EXPECT_THAT(
        loadText(text).diagnostics,
        ElementsAre(
            says("WC0207", lineOf(text, "<instance_controller"),
                 "COLLADA/library_visual_scenes/visual_scene[id=scene]/node[id=body]/instance_controller")));
    const std::string skinned = collada(kMeshes + controllers(skinOf("#hip").text()) + scene(nodes("#skin")));
    EXPECT_THAT(loadText(skinned).diagnostics,
                ElementsAre(says("WC0207", lineOf(skinned, "<skin"),
                                 "COLLADA/library_controllers/controller[id=skin]/skin")));
}

TEST(ControllerLoaderTest, aControllerThatIsAGeometryIsDrawnAsOne) {
    const Model model = loadText(collada(kMeshes + scene(nodes("#mesh"))));
    EXPECT_EQ(model.instances.size(), 1u);
    EXPECT_THAT(codes(model.diagnostics), ElementsAre("WC0207"));
}

TEST(ControllerLoaderTest, aSkinOfNothingIsAnErrorInItsLine) {
    const std::string text = collada(kMeshes + controllers(skinOf("#gone").text()) + scene(nodes("#skin")));
    EXPECT_THAT(loadText(text).diagnostics,
                ElementsAre(says("WC0201", lineOf(text, "<skin"),
                                 "COLLADA/library_controllers/controller[id=skin]/skin")));
}

TEST(ControllerLoaderTest, theLimitOfMorphedPositionsHolds) {
    LoadOptions options;
    options.limits.maxPositions = 15;  // of three meshes, and of two targets
    const std::string text =
        collada(kMeshes + controllers(morph("smile", "#mesh", "high wide", "1 1")) + scene(nodes("#smile")));
    EXPECT_NO_THROW(loadText(text, options));
    options.limits.maxPositions = 14;
    EXPECT_EQ(whyNot(text, options).code, "WC0801");
}

}  // namespace
}  // namespace walkcycle
