#include "loaders/controllers/JointFinder.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <string>

#include "loaders/quirks/Dialect.h"

namespace walkcycle {

// The keys refer to the text of the documents' attributes, which outlives the load.
void JointFinder::indexNewJoints() {
    const std::vector<XmlNode>& nodes = skeletons_.scene().nodes;
    for (; indexed_ < nodes.size(); ++indexed_) {
        const int joint = static_cast<int>(indexed_);
        const XmlNode node = nodes[indexed_];
        if (!node.sid().empty()) bySid_[node.sid()].push_back(joint);
        if (!node.id().empty()) byId_[node.id()].push_back(joint);
        if (!node.attribute("name").empty()) byName_[node.attribute("name")].push_back(joint);
    }
}

int JointFinder::depth(int joint) const {
    int steps = 0;
    for (; joint != kNoParent;
         joint = skeletons_.scene().skeleton.joints[static_cast<std::size_t>(joint)].parent)
        ++steps;
    return steps;
}

int JointFinder::nearestCommonAncestor(int a, int b) const {
    const auto& joints = skeletons_.scene().skeleton.joints;
    while (a != b) {  // parents have smaller indices than their children
        int& later = a > b ? a : b;
        assert(later != kNoParent);  // kNoParent is smaller than any joint
        later = joints[static_cast<std::size_t>(later)].parent;
    }
    return a;
}

bool JointFinder::isBelow(int joint, const std::vector<int>& roots) const {
    if (roots.empty()) return true;
    const auto& joints = skeletons_.scene().skeleton.joints;
    for (; joint != kNoParent; joint = joints[static_cast<std::size_t>(joint)].parent)
        if (std::find(roots.begin(), roots.end(), joint) != roots.end()) return true;
    return false;
}

int JointFinder::pick(const Index& index, std::string_view name, const std::vector<int>& roots,
                      int node) const {
    const auto found = index.find(name);
    if (found == index.end()) return kNoParent;
    constexpr std::size_t kMostCandidates =
        64;  // more joints of one name are a damaged file, and not worth the time
    int best = kNoParent, bestDepth = -1;
    for (std::size_t i = 0; i < std::min(found->second.size(), kMostCandidates); ++i) {
        const int joint = found->second[i];
        if (!isBelow(joint, roots)) continue;
        if (found->second.size() == 1) return joint;
        const int shared = depth(nearestCommonAncestor(joint, node));
        if (shared > bestDepth) best = joint, bestDepth = shared;
    }
    return best;
}

int JointFinder::pickAnywhere(std::string_view name, bool isId, const std::vector<int>& roots, int node,
                              XmlNode from) {
    indexNewJoints();
    const std::vector<int> everywhere;
    const Index* const meant = isId ? &byId_ : &bySid_;
    const Index* const inOrder[] = {meant, isId ? &bySid_ : &byId_, &byName_};
    for (const std::vector<int>& below : {roots, everywhere}) {
        for (const Index* index : inOrder) {
            if (index != meant && !context_.dialects.follows(Quirk::JointsByAnyName, from)) break;
            const int joint = pick(*index, name, below, node);
            if (joint == kNoParent) continue;
            if (index != meant) context_.dialects.note(Quirk::JointsByAnyName, from);
            return joint;
        }
    }
    return kNoParent;
}

// The occurrence of a <node> that is nearest to `node`. If no scene shows the <node>, adds the tree that it
// belongs to, undrawn.
int JointFinder::occurrence(XmlNode element, int node) {
    SceneGraph& scene = skeletons_.scene();
    int best = kNoParent, bestDepth = -1;
    const auto [first, last] = scene.occurrences.equal_range(element);
    for (auto it = first; it != last; ++it) {
        const int shared = depth(nearestCommonAncestor(it->second, node));
        if (shared > bestDepth || (shared == bestDepth && it->second < best))
            best = it->second, bestDepth = shared;
    }
    if (best != kNoParent) return best;
    XmlNode top = element;
    while (top.parent().is("node")) top = top.parent();
    skeletons_.addUndrawn(top);
    const auto added = scene.occurrences.find(element);
    return added == scene.occurrences.end() ? kNoParent : added->second;
}

std::vector<int> JointFinder::skeletonRoots(XmlNode instanceController) {
    std::vector<int> roots;
    for (XmlNode skeleton : instanceController.children("skeleton")) {
        const std::string uri = skeleton.text();
        const XmlNode target = context_.documents.resolve(skeleton, uri);
        if (target.is("visual_scene")) return {};  // the whole scene: every joint is below it
        if (target.is("node"))
            roots.push_back(occurrence(target, kNoParent));
        else
            context_.diagnostics.report(Code::SkeletonNotFound, skeleton, {uri});
    }
    std::erase(roots, kNoParent);
    return roots;
}

int JointFinder::find(std::string_view name, bool isId, const std::vector<int>& roots, int node,
                      XmlNode from) {
    if (const int joint = pickAnywhere(name, isId, roots, node, from); joint != kNoParent) return joint;
    if (!isId && !context_.dialects.follows(Quirk::JointsByAnyName, from)) return kNoParent;
    const XmlNode element = context_.documents.resolve(from, "#" + std::string(name));
    if (!element.is("node")) return kNoParent;
    if (!isId) context_.dialects.note(Quirk::JointsByAnyName, from);
    return occurrence(element, node);
}

}  // namespace walkcycle
