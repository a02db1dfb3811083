#include "app/JointKeys.h"

#include <cstddef>
#include <unordered_map>
#include <utility>

namespace walkcycle {
namespace {

std::string ownName(const Joint& joint) {
    if (!joint.id.empty()) return joint.id;
    if (!joint.name.empty()) return joint.name;
    return joint.sid.empty() ? "node" : joint.sid;
}

// Joints below this depth, or with a longer path, get their own name and a number instead: all their paths together
// would be far larger than the file.
constexpr std::size_t kDeepestPath = 128, kLongestPath = 1000;

// The names from the root to the joint.
std::string path(const Skeleton& skeleton, std::size_t joint) {
    std::vector<std::string> names;
    std::size_t length = 0;
    for (int i = static_cast<int>(joint); i != kNoParent;
         i = skeleton.joints[static_cast<std::size_t>(i)].parent) {
        names.push_back(ownName(skeleton.joints[static_cast<std::size_t>(i)]));
        length += names.back().size() + 1;
        if (names.size() > kDeepestPath || length > kLongestPath) return names.front();
    }
    std::string text;
    for (auto name = names.rbegin(); name != names.rend(); ++name) text += (text.empty() ? "" : "/") + *name;
    return text;
}

}  // namespace

std::vector<std::string> jointKeys(const Skeleton& skeleton) {
    std::vector<std::string> keys;
    std::unordered_map<std::string, std::size_t> taken;  // key -> how many later joints have the same
    keys.reserve(skeleton.joints.size());
    for (std::size_t i = 0; i < skeleton.joints.size(); ++i) {
        std::string key = ownName(skeleton.joints[i]);
        if (taken.contains(key)) key = path(skeleton, i);
        // Nodes of one name below one parent have the same path, too.
        const std::string shared = key;
        while (taken.contains(key)) key = shared + "[" + std::to_string(++taken[shared] + 1) + "]";
        taken.emplace(key, 0);
        keys.push_back(std::move(key));
    }
    return keys;
}

}  // namespace walkcycle
