#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "walkcycle/model/Model.h"

namespace walkcycle {
namespace {

// The joint for each id, name and sid. If two joints have the same word, an id wins over a name, and a name
// over a sid.
std::unordered_map<std::string, int> jointsByName(const Skeleton& skeleton) {
    std::unordered_map<std::string, int> joints;
    for (const std::string Joint::*name : {&Joint::id, &Joint::name, &Joint::sid})
        for (std::size_t i = 0; i < skeleton.joints.size(); ++i)
            if (!(skeleton.joints[i].*name).empty())
                joints.emplace(skeleton.joints[i].*name, static_cast<int>(i));
    return joints;
}

// The joint of the other model with one of these names; kNoParent if there is none.
int counterpart(const Joint& joint, const std::unordered_map<std::string, int>& joints) {
    for (const std::string* name : {&joint.id, &joint.name, &joint.sid})
        if (const auto found = joints.find(*name); !name->empty() && found != joints.end())
            return found->second;
    return kNoParent;
}

void scaleDistances(Channel& channel, float scale) {
    for (KeyFrame& key : channel.keyFrames) key.transform.position *= scale;
    for (KeyTangents& tangents : channel.tangents) {
        tangents.in.position *= scale;
        tangents.out.position *= scale;
    }
    for (MatrixKeyFrame& key : channel.matrixKeyFrames)
        key.matrix[3] = glm::vec4(glm::vec3(key.matrix[3]) * scale, 1.0f);
}

}  // namespace

std::vector<Animation> borrowClips(const Model& source, const Model& model) {
    const std::unordered_map<std::string, int> joints = jointsByName(model.skeleton);
    const float scale = static_cast<float>(source.asset.metersPerUnit / model.asset.metersPerUnit);
    std::vector<Animation> clips;
    for (const Animation& clip : source.animations) {
        Animation borrowed = clip;
        borrowed.channels.clear();
        borrowed.parameterTracks.clear();  // their parameters are those of the source
        for (const Channel& channel : clip.channels) {
            const int joint =
                counterpart(source.skeleton.joints[static_cast<std::size_t>(channel.joint)], joints);
            if (joint == kNoParent) continue;
            borrowed.channels.push_back(channel);
            borrowed.channels.back().joint = joint;
            if (scale != 1.0f) scaleDistances(borrowed.channels.back(), scale);
        }
        if (!borrowed.channels.empty()) clips.push_back(std::move(borrowed));
    }
    if (source.animations.empty()) throw NothingToBorrow("'" + source.file + "' has no animation");
    if (clips.empty())
        throw NothingToBorrow("'" + source.file + "' moves no joint that '" + model.file + "' has");
    return clips;
}

}  // namespace walkcycle
