#pragma once

#include <cstddef>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/scene/SceneGraph.h"
#include "loaders/scene/SkeletonLoader.h"

namespace walkcycle {

// Finds the joints that a skin names (COLLADA 1.4.1, chapter 5, <joints> and <skeleton>). The names of a
// Name_array are sids, searched below the roots that <skeleton> gives; those of an IDREF_array are ids. The
// quirk joints-by-any-name also accepts an id or a name. If no scene shows a joint, it is added from
// <library_nodes>.
class JointFinder {
public:
    JointFinder(const LoadContext& context, SkeletonLoader& skeletons)
        : context_(context), skeletons_(skeletons) {}

    // The joints that the <skeleton>s of an <instance_controller> name. Empty if it has none or none can be
    // found, and then the whole scene is searched.
    std::vector<int> skeletonRoots(XmlNode instanceController);

    // Returns a joint, or kNoParent if there is none. `node` is the joint that carries the instance: if a
    // name has several joints, the one with the deepest common ancestor with `node` is meant. `from` is the
    // <skin>; ids are searched in its document.
    int find(std::string_view name, bool isId, const std::vector<int>& roots, int node, XmlNode from);

    int nearestCommonAncestor(int a, int b) const;  // kNoParent if there is none

private:
    using Index = std::unordered_map<std::string_view, std::vector<int>>;
    void indexNewJoints();
    int pick(const Index& index, std::string_view name, const std::vector<int>& roots, int node) const;
    int pickAnywhere(std::string_view name, bool isId, const std::vector<int>& roots, int node, XmlNode from);
    bool isBelow(int joint, const std::vector<int>& roots) const;
    int occurrence(XmlNode element, int node);
    int depth(int joint) const;

    const LoadContext& context_;
    SkeletonLoader& skeletons_;
    Index bySid_, byId_, byName_;
    std::size_t indexed_ = 0;  // how many joints are in the indices above
};

}  // namespace walkcycle
