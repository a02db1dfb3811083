#include "LoadText.h"
#include "loaders/MeshLibrary.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;

std::string instance(const std::string& url) {
    return "<node><instance_geometry url='" + url + "'/></node>";
}

TEST(MeshLibraryTest, aGeometryIsReadOnceHoweverOftenItIsInstanced) {
    const Model model = loadText(collada(triangle() + triangle("other") +
                                         scene(instance("#mesh") + instance("#other") + instance("#mesh"))));
    EXPECT_EQ(model.meshes.size(), 2u);
    ASSERT_EQ(model.instances.size(), 3u);
    EXPECT_EQ(model.instances[2].mesh, model.instances[0].mesh);
}

TEST(MeshLibraryTest, whatIsOnlyMorphedToIsNoMeshOfTheModel) {
    const Model model = loadText(collada(triangle() + triangle("unused") + scene(instance("#mesh"))));
    EXPECT_EQ(model.meshes.size(), 1u);
}

TEST(MeshLibraryTest, aGeometrysOwnUnitAndAxisAreBroughtToTheDocuments) {
    std::string text = collada(triangle("mesh", "0 0 0 100 0 0 0 0 100") + scene(instance("#mesh")));
    const std::string tag = "<geometry id=\"mesh\">";
    text.insert(text.find(tag) + tag.size(), "<asset><unit meter='0.01'/><up_axis>Z_UP</up_axis></asset>");
    EXPECT_THAT(posed(loadText(text)), ElementsAre(isAt(0, 0, 0), isAt(1, 0, 0), isAt(0, 1, 0)));
}

TEST(MeshLibraryTest, aGeometryOfAnotherDocumentBringsItsUnitAndAxis) {
    std::string other = collada(triangle("mesh", "0 0 0 100 0 0 0 0 100"));
    other.replace(other.find("meter=\"1\""), 9, "meter=\"0.01\"");
    other.replace(other.find("Y_UP"), 4, "Z_UP");
    LoadOptions options;
    options.resolver = [&](const std::string&) { return std::optional(bytesOf(other)); };
    const Model model = loadText(collada(scene(instance("other.dae#mesh"))), options);
    EXPECT_THAT(posed(model), ElementsAre(isAt(0, 0, 0), isAt(1, 0, 0), isAt(0, 1, 0)));
    EXPECT_EQ(model.instances[0].sourceUrl, "other.dae#mesh");
}

}  // namespace
}  // namespace walkcycle
