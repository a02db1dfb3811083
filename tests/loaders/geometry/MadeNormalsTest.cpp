#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "loaders/LoadText.h"
#include "model/Deformers.h"
#include "walkcycle/animation/Animator.h"
#include "walkcycle/model/CpuSkinning.h"

namespace walkcycle {
namespace {

const std::string kStrip = "-1 0 0 -1 1 0 0 0 0 0 1 0 1 0 0 1 1 0";
const std::string kBentStrip = "-1 0 0 -1 1 0 0 0 0 0 1 0 0 0 -1 0 1 -1";
const std::string kStripFaces = "<vcount>4 4</vcount><p>0 2 3 1 2 4 5 3</p>";

const std::string kFlatFan = "0 0 0 -1 -1 0 1 -1 0 1 1 0 -1 1 0";
const std::string kPyramid = "0 0 3 -1 -1 0 1 -1 0 1 1 0 -1 1 0";
const std::string kFanFaces = "<vcount>3 3 3 3</vcount><p>0 1 2 0 2 3 0 3 4 0 4 1</p>";

// A <geometry> without normals.
std::string mesh(const std::string& id, const std::string& positions, const std::string& faces) {
    return "<library_geometries><geometry id='" + id + "'><mesh>" + floatSource(id + "-pos", positions) +
           "<vertices id='" + id + "-verts'><input semantic='POSITION' source='#" + id +
           "-pos'/></vertices><polylist count='4'><input semantic='VERTEX' offset='0' source='#" + id +
           "-verts'/>" + faces + "</polylist></mesh></geometry></library_geometries>";
}

std::string morph(const std::string& weight) {
    return controllers("<controller id='morph'><morph source='#shape'>" +
                       nameSource("targets", "wanted", "IDREF_array") + floatSource("amounts", weight, "W") +
                       "<targets><input semantic='MORPH_TARGET' source='#targets'/>"
                       "<input semantic='MORPH_WEIGHT' source='#amounts'/></targets></morph></controller>");
}

// The strip's right end follows the knee.
std::string skin(const std::string& source) {
    SkinText skin;
    skin.source = source;
    skin.inverseBinds = matrixSource("binds", kIdentity + kIdentity);
    skin.positions = 6;
    skin.vcount = "1 1 1 1 1 1";
    skin.v = "0 0 0 0 0 0 0 0 1 0 1 0";
    return controllers(skin.text());
}

// First the rigid mesh "wanted", then the controller's, both under the same transform.
std::string nodes(const std::string& transform, const std::string& controller, const std::string& knee) {
    return scene("<node id='rigid'>" + transform +
                 "<instance_geometry url='#wanted'/></node>"
                 "<node id='hip' sid='hip' type='JOINT'>" +
                 transform + "<node id='knee' sid='knee' type='JOINT'>" + knee +
                 "</node></node>"
                 "<node id='deformed'>" +
                 transform + "<instance_controller url='#" + controller +
                 "'><skeleton>#hip</skeleton></instance_controller></node>");
}

const std::string kKneeBent = "<rotate>0 1 0 90</rotate>";

// The normals of an instance as its triangles' corners have them.
std::vector<glm::vec3> drawnNormals(const Model& model, std::size_t instance) {
    const std::vector<float> parameters = model.restParameters();
    const Animator animator(model.skeleton, parameters);
    std::vector<glm::vec3> positions, normals, drawn;
    CpuSkinning().vertices(model, model.instances.at(instance), animator.modelTransforms(),
                           animator.parameters(), positions, normals);
    const auto& mesh = model.meshes.at(static_cast<std::size_t>(model.instances[instance].mesh));
    for (const std::uint32_t vertex : mesh.indices) drawn.push_back(normals[vertex]);
    return drawn;
}

void expectTheSameNormals(const Model& model) {
    const std::vector<glm::vec3> wanted = drawnNormals(model, 0), deformed = drawnNormals(model, 1);
    ASSERT_EQ(wanted.size(), deformed.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        EXPECT_LT(glm::length(wanted[i] - deformed[i]), 1e-5f) << "corner " << i;
}

TEST(MadeNormalsTest, aFlatFanThatIsMorphedToAPyramidHasThePyramidsCreases) {
    const Model model =
        loadText(collada(mesh("shape", kFlatFan, kFanFaces) + mesh("wanted", kPyramid, kFanFaces) +
                         morph("1") + nodes("", "morph", "")));

    expectTheSameNormals(model);
    const std::vector<glm::vec3> normals = drawnNormals(model, 1);
    EXPECT_LT(glm::length(normals[0] - glm::normalize(glm::vec3(0, -3, 1))), 1e-5f);
    EXPECT_LT(glm::length(normals[3] - glm::normalize(glm::vec3(3, 0, 1))), 1e-5f);
}

TEST(MadeNormalsTest, aStripThatASkinBendsHasTheNormalsOfABentStrip) {
    for (const std::string& bent :
         {kBentStrip, std::string("-1 0 0 -1 1 0 0 0 0 0 1 0 0.8 0 -0.6 0.8 1 -0.6")}) {
        const std::string knee = bent == kBentStrip ? kKneeBent : "<rotate>0 1 0 36.8698976</rotate>";
        expectTheSameNormals(
            loadText(collada(mesh("shape", kStrip, kStripFaces) + mesh("wanted", bent, kStripFaces) +
                             skin("#shape") + nodes("", "skin", knee))));
    }
}

TEST(MadeNormalsTest, aSkinOverAMorphHasThoseOfWhatBothMake) {
    expectTheSameNormals(loadText(collada(
        mesh("shape", kStrip, kStripFaces) +
        mesh("target", "-1 0 1 -1 1 1 0 0 0 0 1 0 1 0 0 1 1 0", kStripFaces) +
        mesh("wanted", "-1 0 1 -1 1 1 0 0 0 0 1 0 0 0 -1 0 1 -1", kStripFaces) +
        controllers("<controller id='morph'><morph source='#shape'>" +
                    nameSource("targets", "target", "IDREF_array") + floatSource("amounts", "1", "W") +
                    "<targets><input semantic='MORPH_TARGET' source='#targets'/><input "
                    "semantic='MORPH_WEIGHT' source='#amounts'/></targets></morph></controller>") +
        skin("#morph") + nodes("", "skin", kKneeBent))));
}

TEST(MadeNormalsTest, mirroredAndStretchedOnesLookOutsideAsRigidOnesDo) {
    const std::string fans = mesh("shape", kFlatFan, kFanFaces) + mesh("wanted", kPyramid, kFanFaces);
    const std::string strips = mesh("shape", kStrip, kStripFaces) + mesh("wanted", kBentStrip, kStripFaces);

    expectTheSameNormals(loadText(collada(fans + morph("1") + nodes("<scale>-1 3 1</scale>", "morph", ""))));
    expectTheSameNormals(
        loadText(collada(strips + skin("#shape") + nodes("<scale>-1 1 1</scale>", "skin", kKneeBent))));
}

TEST(MadeNormalsTest, onlyMeshesThatDeformAndHaveNoNormalsPayForIt) {
    const Model model =
        loadText(collada(mesh("shape", kFlatFan, kFanFaces) + mesh("wanted", kFlatFan, kFanFaces) +
                         morph("0") + nodes("", "morph", "")));

    EXPECT_EQ(model.meshes.at(0).vertexCount(), 5u);
    EXPECT_TRUE(shaderCanDeform(model, model.instances.at(0)));
    EXPECT_EQ(model.meshes.at(1).vertexCount(), 12u);
    EXPECT_FALSE(shaderCanDeform(model, model.instances.at(1)));
}

}  // namespace
}  // namespace walkcycle
