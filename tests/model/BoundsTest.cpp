#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "walkcycle/model/Bounds.h"

namespace walkcycle {
namespace {

// A segment from x = 0 to x = 1 on a node, and a position that nothing draws.
Model segment() {
    Model model;
    model.skeleton.joints.resize(1);
    model.nodeVisible = {true};
    MeshData mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1000, 0}};
    mesh.vertexPositions = {0, 1};
    model.meshes = {mesh};
    model.instances.resize(1);
    return model;
}

Animation rise() {
    Animation clip;
    clip.endSeconds = 1.0;
    clip.channels = {{.joint = 0, .keyFrames = {{0.0, {}}, {1.0, {.position = {0, 3, 0}}}}}};
    return clip;
}

TEST(BoundsTest, areEmptyUntilSomethingIsAdded) {
    Bounds box;
    EXPECT_TRUE(box.empty());
    EXPECT_FLOAT_EQ(box.diagonal(), 0.0f);

    box.add({1, 2, 3});
    box.add(Bounds{});
    EXPECT_EQ(box.center(), glm::vec3(1, 2, 3));
    box.add({1, 6, 0});
    EXPECT_FLOAT_EQ(box.diagonal(), 5.0f);
}

TEST(BoundsTest, leaveOutPositionsThatNothingDraws) {
    const Bounds box = bounds(segment(), {glm::mat4(1.0f)}, {});

    EXPECT_EQ(box.max, glm::vec3(1, 0, 0));
}

TEST(BoundsTest, leaveOutWhatIsNeverSeen) {
    Model model = segment();
    model.nodeVisible[0] = false;
    EXPECT_TRUE(bounds(model, {glm::mat4(1.0f)}, {}).empty());

    model.parameters = {{ParameterKind::NodeVisible, 0, 0, 0.0f}};
    EXPECT_FALSE(bounds(model, {glm::mat4(1.0f)}, {}).empty());
}

TEST(BoundsTest, overAClipReachFromItsFirstToItsLastPose) {
    const Model model = segment();
    const Animation clip = rise();
    const Bounds box = animatedBounds(model, &clip);

    EXPECT_FLOAT_EQ(box.min.y, 0.0f);
    EXPECT_FLOAT_EQ(box.max.y, 3.0f);
}

TEST(BoundsTest, withoutAClipAreThoseOfTheRestPose) {
    Model model = segment();
    model.skeleton.joints[0].localBindTransform[3] = {0, 7, 0, 1};

    EXPECT_FLOAT_EQ(animatedBounds(model, nullptr).min.y, 7.0f);
}

}  // namespace
}  // namespace walkcycle
