#include "app/JointKeys.h"

#include <unordered_set>

namespace walkcycle {
namespace {

std::string ownName(const Joint& joint) {
    if (!joint.id.empty()) return joint.id;
    if (!joint.name.empty()) return joint.name;
    return joint.sid.empty() ? "node" : joint.sid;
}

// Walks upwards, so its cost is the depth; only those whose name is taken need it.
std::string path(const Skeleton& skeleton, std::size_t joint) {
    std::vector<std::string> names;
    for (int i = static_cast<int>(joint); i != kNoParent;
         i = skeleton.joints[static_cast<std::size_t>(i)].parent)
        names.push_back(ownName(skeleton.joints[static_cast<std::size_t>(i)]));
    std::string text;
    for (auto name = names.rbegin(); name != names.rend(); ++name) text += (text.empty() ? "" : "/") + *name;
    return text;
}

}  // namespace

std::vector<std::string> jointKeys(const Skeleton& skeleton) {
    std::vector<std::string> keys;
    std::unordered_set<std::string> taken;
    keys.reserve(skeleton.joints.size());
    for (std::size_t i = 0; i < skeleton.joints.size(); ++i) {
        std::string key = ownName(skeleton.joints[i]);
        if (taken.contains(key)) key = path(skeleton, i);
        // Twins beneath one parent have one path, too.
        for (std::size_t twin = 2; taken.contains(key); ++twin)
            key = path(skeleton, i) + "[" + std::to_string(twin) + "]";
        taken.insert(key);
        keys.push_back(std::move(key));
    }
    return keys;
}

}  // namespace walkcycle
