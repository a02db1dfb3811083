#pragma once

#include <map>
#include <string>
#include <vector>

#include "walkcycle/model/Model.h"

namespace walkcycle::bench {

// The series' own way of playing, written plainly: key frames that hold a map from joint names to transforms, a list
// searched from its start, a map of names to matrices made for each frame, and a recursion over a tree of joints. It is
// what our Animator is measured against; nothing else uses it.
class SeriesAnimator {
public:
    SeriesAnimator(const Model& model, const Animation& animation, int keyFrames);

    void setTime(double seconds) { time_ = seconds; }
    const std::vector<glm::mat4>& update();  // the palette of the model's first skin

private:
    struct TreeJoint {
        int index = -1;  // in the palette; -1: in no skin
        std::string name;
        glm::mat4 inverseBind{1.0f};
        std::vector<TreeJoint> children;
    };
    struct SeriesKeyFrame {
        double timeStamp = 0.0;
        std::map<std::string, JointTransform> pose;
    };

    TreeJoint treeFrom(const Model& model, const Skin& skin, int joint) const;
    std::map<std::string, glm::mat4> currentPose() const;
    void applyPoseToJoints(const std::map<std::string, glm::mat4>& pose, const TreeJoint& joint,
                           const glm::mat4& parentTransform);

    std::vector<TreeJoint> roots_;
    std::vector<SeriesKeyFrame> keyFrames_;
    std::vector<glm::mat4> palette_;
    double time_ = 0.0;
};

}  // namespace walkcycle::bench
