#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "walkcycle/animation/Pose.h"

namespace walkcycle {
namespace {

TEST(PoseTest, startsAsTheFileHasTheJointsAtRest) {
    Skeleton skeleton;
    skeleton.joints.resize(3);
    skeleton.joints[1].localBindTransform = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, -100.0f, 0.0f));
    const Pose pose(skeleton);

    ASSERT_EQ(pose.size(), 3u);
    EXPECT_EQ(pose.localTransform(1), skeleton.joints[1].localBindTransform);
}

TEST(PoseTest, aJointIsATransformOrAMatrix) {
    Skeleton skeleton;
    skeleton.joints.resize(2);
    Pose pose(skeleton);
    const JointTransform raised{.position = {0.0f, 2.0f, 0.0f}};
    pose.set(0, raised);
    pose.set(1, glm::mat4(3.0f));

    EXPECT_EQ(pose.localTransform(0), raised.toMatrix());
    EXPECT_EQ(pose.localTransform(1), glm::mat4(3.0f));
}

}  // namespace
}  // namespace walkcycle
