#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/geometry/MeshLibrary.h"

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

// The triangle with a line along its first edge, a face that a bad index spoils, and whatever else.
std::string withLine(const std::string& more = "") {
    std::string text = triangle();
    const std::string input = "<input semantic='VERTEX' source='#mesh-vertices' offset='0'/>";
    text.insert(text.find("<triangles"), "<lines count='1'>" + input + "<p>0 1</p></lines>");
    text.insert(text.find("</mesh>"),
                "<triangles count='2'>" + input + "<p>0 1 9 2 1 0</p></triangles>" + more);
    return text;
}

TEST(MeshLibraryTest, aDeformedMeshKeepsItsLinesAndLeavesOutWhatIsSpoilt) {
    SkinText skin;
    skin.joints = nameSource("joints", "hip hip2");
    skin.inverseBinds = matrixSource("binds", kIdentity + kIdentity);
    const Model model = loadText(
        collada(withLine() + controllers(skin.text()) +
                scene("<node sid='hip'/><node sid='hip2'/><node><instance_controller url='#skin'/></node>")));
    const MeshData& mesh = model.meshes.at(0);
    ASSERT_EQ(mesh.parts.size(), 3u);
    EXPECT_EQ(mesh.indices.size(), 8u);  // a line and two triangles
    EXPECT_EQ(mesh.parts[0].primitive, Primitive::Lines);
    std::vector<std::uint32_t> drawn;
    for (const std::uint32_t vertex : mesh.indices) drawn.push_back(mesh.vertexPositions.at(vertex));
    EXPECT_THAT(drawn, ElementsAre(0, 1, 0, 1, 2, 2, 1, 0));
    EXPECT_EQ(mesh.normals.size(), mesh.vertexCount());
}

TEST(MeshLibraryTest, aDeformedMeshRepeatsItsTextureCoordinatesWithItsCorners) {
    const std::string textured =
        floatSource("uv", "0 0 1 0 0.5 1", "ST") +
        "<triangles count='2'><input semantic='VERTEX' "
        "source='#mesh-vertices' offset='0'/><input semantic='TEXCOORD' source='#uv' offset='0'/>"
        "<p>0 1 2 0 1 2</p></triangles>";
    SkinText skin;
    skin.inverseBinds = matrixSource("binds", kIdentity + kIdentity);
    std::string text = triangle();
    text.insert(text.find("</mesh>"), textured);
    const Model model = loadText(collada(text + controllers(skin.text()) +
                                         scene("<node sid='hip'/><node sid='knee'/><node>"
                                               "<instance_controller url='#skin'/></node>")));
    const MeshData& mesh = model.meshes.at(0);
    ASSERT_EQ(mesh.texCoordSets.size(), 1u);
    ASSERT_EQ(mesh.texCoordSets[0].coords.size(), mesh.vertexCount());
    EXPECT_EQ(mesh.texCoordSets[0].coords[mesh.indices.back()], glm::vec2(0.5f, 1.0f));
}

TEST(MeshLibraryTest, aGeometrysOwnAxisTurnsItsNormalsToo) {
    std::string text = collada(withLine() + scene(instance("#mesh")));
    const std::string up = floatSource("up", "0 0 1 0 0 1 0 0 1");
    text.insert(text.find("<vertices"), up);
    text.insert(text.find("</vertices>"), "<input semantic='NORMAL' source='#up'/>");
    const std::string tag = "<geometry id=\"mesh\">";
    text.insert(text.find(tag) + tag.size(), "<asset><up_axis>Z_UP</up_axis></asset>");
    const MeshData mesh = loadText(text).meshes.at(0);
    EXPECT_THAT(mesh.normals[mesh.indices.back()], isAt(0, 1, 0));
    EXPECT_EQ(mesh.normals[mesh.indices.front()], glm::vec3(0.0f)) << "lines have no normals";
}

TEST(MeshLibraryTest, positionsThatPrimitivesShareStandOnce) {
    std::string text = triangle();
    text.insert(text.find("</mesh>"), floatSource("far", "9 0 0 9 1 0 9 0 1") +
                                          "<triangles count='1'><input semantic='POSITION' source='#far' "
                                          "offset='0'/><p>0 1 2</p></triangles>"
                                          "<triangles count='1'><input semantic='POSITION' source='#far' "
                                          "offset='0'/><p>2 1 0</p></triangles>");
    const Model model = loadText(collada(text + scene(instance("#mesh"))));
    EXPECT_EQ(model.meshes.at(0).positions.size(), 6u);
    EXPECT_EQ(model.meshes.at(0).indices.size(), 9u);
}

}  // namespace
}  // namespace walkcycle
