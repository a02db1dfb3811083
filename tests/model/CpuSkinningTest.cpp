#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "walkcycle/model/CpuSkinning.h"

namespace walkcycle {
namespace {

constexpr Deformer kSkin{Deformer::Kind::Skin, 0, 0};
constexpr Deformer morphOf(int index) {
    return {Deformer::Kind::Morph, index, 0};
}

glm::mat4 moved(float x, float y, float z) {
    return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
}

// A mesh of one point at (1, 0, 0) that looks along x and y, on node 0; node 1 is the joint of the only skin.
Model onePoint(std::vector<Deformer> deformers) {
    Model model;
    model.skeleton.joints.resize(2);
    MeshData mesh;
    mesh.positions = {{1.0f, 0.0f, 0.0f}};
    mesh.vertexPositions = {0};
    mesh.normals = {glm::normalize(glm::vec3(1.0f, 1.0f, 0.0f))};
    model.meshes = {mesh};
    Skin skin;
    skin.joints = {1, 0};
    skin.bindMatrices = {glm::mat4(1.0f), glm::mat4(1.0f)};
    model.skins = {skin};
    Influences influences;
    influences.first = {0, 1};
    influences.influences = {{0, 1.0f}};
    model.influences = {influences};
    MeshInstance instance;
    instance.deformers = std::move(deformers);
    model.instances = {instance};
    return model;
}

// Adds a morph whose targets move the point by the given deltas.
void addMorph(Model& model, MorphMethod method, int firstParameter, const std::vector<glm::vec3>& deltas) {
    MorphTargets morph;
    morph.method = method;
    morph.firstParameter = firstParameter;
    for (const glm::vec3& delta : deltas) morph.targets.push_back({"", {delta}, {}});
    model.morphs.push_back(morph);
}

glm::vec3 deformed(const Model& model, const std::vector<glm::mat4>& transforms,
                   std::vector<float> parameters = {}) {
    std::vector<glm::vec3> positions;
    CpuSkinning().positions(model, model.instances[0], transforms, parameters, positions);
    return positions.at(0);
}

glm::vec3 deformedNormal(const Model& model, const std::vector<glm::mat4>& transforms) {
    std::vector<glm::vec3> positions, normals;
    CpuSkinning().vertices(model, model.instances[0], transforms, {}, positions, normals);
    return normals.at(0);
}

void expectNear(const glm::vec3& actual, const glm::vec3& expected) {
    EXPECT_NEAR(actual.x, expected.x, 1e-5f);
    EXPECT_NEAR(actual.y, expected.y, 1e-5f);
    EXPECT_NEAR(actual.z, expected.z, 1e-5f);
}

TEST(CpuSkinningTest, aRigidMeshStandsAtItsNode) {
    expectNear(deformed(onePoint({}), {moved(0, 5, 0), moved(9, 9, 9)}), {1, 5, 0});
}

TEST(CpuSkinningTest, aSkinnedMeshFollowsItsJointsAndNotItsNode) {
    expectNear(deformed(onePoint({kSkin}), {moved(9, 9, 9), moved(0, 5, 0)}), {1, 5, 0});
}

TEST(CpuSkinningTest, everyInfluenceCounts) {
    Model model = onePoint({kSkin});
    model.skins[0].joints = {0, 1, 0};
    model.skins[0].bindMatrices.assign(3, glm::mat4(1.0f));
    model.influences[0].first = {0, 3};
    model.influences[0].influences = {{0, 0.25f}, {1, 0.5f}, {2, 0.25f}};

    expectNear(deformed(model, {moved(0, 0, 0), moved(0, 8, 0)}), {1, 4, 0});
}

TEST(CpuSkinningTest, normalsStayUprightOnUnevenlyScaledSurfaces) {
    const Model model = onePoint({kSkin});
    const glm::mat4 wide = glm::scale(glm::mat4(1.0f), glm::vec3(2.0f, 1.0f, 1.0f));

    expectNear(deformedNormal(model, {wide, wide}), glm::normalize(glm::vec3(0.5f, 1.0f, 0.0f)));
}

TEST(CpuSkinningTest, normalsOfAMirroredMeshPointOutside) {
    const glm::mat4 mirrored = glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 1.0f));

    expectNear(deformedNormal(onePoint({}), {mirrored, mirrored}),
               glm::normalize(glm::vec3(-1.0f, 1.0f, 0.0f)));
}

TEST(CpuSkinningTest, aVertexThatIsFlattenedKeepsAFiniteNormal) {
    const glm::vec3 normal = deformedNormal(onePoint({}), {glm::mat4(0.0f), glm::mat4(0.0f)});

    EXPECT_TRUE(std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z));
}

TEST(CpuSkinningTest, verticesAreCornersAtTheirPositions) {
    Model model = onePoint({});
    model.meshes[0].positions.push_back({7.0f, 0.0f, 0.0f});
    model.meshes[0].vertexPositions = {1, 0, 1};
    model.meshes[0].normals.assign(3, glm::vec3(0.0f));  // of a line: none
    std::vector<glm::vec3> positions, normals;
    CpuSkinning().vertices(model, model.instances[0], {moved(0, 1, 0), glm::mat4(1.0f)}, {}, positions,
                           normals);

    ASSERT_EQ(positions.size(), 3u);
    expectNear(positions[0], {7, 1, 0});
    expectNear(positions[1], {1, 1, 0});
    expectNear(normals[2], {0, 0, 0});
}

TEST(CpuSkinningTest, morphsAddTheirWeightedDifferences) {
    Model model = onePoint({morphOf(0)});
    addMorph(model, MorphMethod::Relative, 1, {{0, 2, 0}, {0, 0, 4}});

    expectNear(deformed(model, {moved(0, 0, 1), glm::mat4(1.0f)}, {9.0f, 0.5f, 0.25f}), {1, 1, 2});
}

TEST(CpuSkinningTest, normalsFollowTheMorph) {
    Model model = onePoint({morphOf(0)});
    addMorph(model, MorphMethod::Relative, 0, {{0, 0, 0}});
    model.morphs[0].targets[0].normalDeltas = {glm::vec3(0, 0, 1) - model.meshes[0].normals[0]};
    std::vector<glm::vec3> positions, normals;
    CpuSkinning().vertices(model, model.instances[0], {glm::mat4(1.0f), glm::mat4(1.0f)},
                           std::vector<float>{1.0f}, positions, normals);

    expectNear(normals[0], {0, 0, 1});
}

TEST(CpuSkinningTest, skinOverMorphTurnsTheMorphedShape) {
    Model model = onePoint({morphOf(0), kSkin});
    addMorph(model, MorphMethod::Normalized, 0, {{0, 2, 0}});
    const glm::mat4 quarterTurn = glm::rotate(glm::mat4(1.0f), glm::radians(90.0f), glm::vec3(0, 0, 1));

    expectNear(deformed(model, {glm::mat4(1.0f), quarterTurn}, {1.0f}), {-2, 1, 0});
}

// The skinned point is (1, 5, 0) in the scene, (1, 3, 0) seen from the node.
TEST(CpuSkinningTest, relativeMorphOverSkinAddsInTheNodesSpace) {
    Model model = onePoint({kSkin, morphOf(0)});
    addMorph(model, MorphMethod::Relative, 0, {{0, 0, 4}});

    expectNear(deformed(model, {moved(0, 2, 0), moved(0, 5, 0)}, {0.5f}), {1, 5, 2});
}

// Half of (1, 3, 0), half of the target, which is the file's (1, 0, 0) + (0, 0, 4); then the node's two up.
TEST(CpuSkinningTest, normalizedMorphOverSkinBlendsFromTheSkinnedShapeToTheTarget) {
    Model model = onePoint({kSkin, morphOf(0)});
    addMorph(model, MorphMethod::Normalized, 0, {{0, 0, 4}});

    expectNear(deformed(model, {moved(0, 2, 0), moved(0, 5, 0)}, {0.5f}), {1, 3.5f, 2});
}

}  // namespace
}  // namespace walkcycle
