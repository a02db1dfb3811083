#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "animation/Pose.h"

namespace walkcycle {
namespace {

glm::mat4 moved(float x, float y, float z) {
    return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
}

// hip -> knee -> foot, one metre each, in a document whose unit is the centimetre.
Skeleton leg() {
    Skeleton skeleton;
    skeleton.joints.resize(3);
    skeleton.joints[0].localBindTransform = moved(0.0f, 300.0f, 0.0f);
    skeleton.joints[1].localBindTransform = moved(0.0f, -100.0f, 0.0f);
    skeleton.joints[1].parent = 0;
    skeleton.joints[2].localBindTransform = moved(0.0f, -100.0f, 0.0f);
    skeleton.joints[2].parent = 1;
    skeleton.rootTransform = glm::scale(glm::mat4(1.0f), glm::vec3(0.01f));
    return skeleton;
}

TEST(PoseTest, startsAsTheFileHasTheJointsAtRest) {
    const Skeleton skeleton = leg();
    const Pose pose(skeleton);

    ASSERT_EQ(pose.size(), 3u);
    EXPECT_EQ(pose.localTransform(1), skeleton.joints[1].localBindTransform);
}

TEST(PoseTest, jointsAreCarriedByTheirParentsAndConvertedOnce) {
    std::vector<glm::mat4> transforms;
    modelTransforms(leg(), Pose(leg()), transforms);

    ASSERT_EQ(transforms.size(), 3u);
    EXPECT_FLOAT_EQ(transforms[0][3].y, 3.0f);
    EXPECT_FLOAT_EQ(transforms[2][3].y, 1.0f);
    EXPECT_FLOAT_EQ(transforms[2][0].x, 0.01f);
}

TEST(PoseTest, aTurnedHipSwingsTheFoot) {
    Pose pose(leg());
    pose.set(0, JointTransform{.position = {0.0f, 300.0f, 0.0f},
                               .rotation = glm::angleAxis(glm::radians(90.0f), glm::vec3(0.0f, 0.0f, 1.0f))});
    std::vector<glm::mat4> transforms;
    modelTransforms(leg(), pose, transforms);

    EXPECT_NEAR(transforms[2][3].x, 2.0f, 1e-5f);
    EXPECT_NEAR(transforms[2][3].y, 3.0f, 1e-5f);
}

TEST(PoseTest, twoRootsStandApart) {
    Skeleton skeleton;
    skeleton.joints.resize(2);
    skeleton.joints[0].localBindTransform = moved(1.0f, 0.0f, 0.0f);
    skeleton.joints[1].localBindTransform = moved(0.0f, 2.0f, 0.0f);
    std::vector<glm::mat4> transforms;
    modelTransforms(skeleton, Pose(skeleton), transforms);

    EXPECT_FLOAT_EQ(transforms[1][3].x, 0.0f);
    EXPECT_FLOAT_EQ(transforms[1][3].y, 2.0f);
}

}  // namespace
}  // namespace walkcycle
