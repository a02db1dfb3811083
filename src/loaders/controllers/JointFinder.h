#pragma once

#include <cstddef>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/scene/SceneGraph.h"
#include "loaders/scene/SkeletonLoader.h"

namespace walkcycle {

// Finds the joints that skins name. COLLADA 1.4.1, <joints> and <skeleton>: names of a Name_array are sids, looked for
// below the skeleton's roots; those of an IDREF_array are ids. The quirk joints-by-any-name lets an id or a name do.
// Joints that no scene shows are fetched from <library_nodes>.
class JointFinder {
public:
    JointFinder(const LoadContext& context, SkeletonLoader& skeletons)
        : context_(context), skeletons_(skeletons) {}

    // The joints that the <skeleton>s of an <instance_controller> name; empty where it has none (or none that is there).
    std::vector<int> skeletonRoots(XmlNode instanceController);

    // `node` is the joint that the instance hangs on: of several occurrences the nearest is meant. kNoParent if
    // there is none. `from` is the skin, whose document ids belong to.
    int find(std::string_view name, bool isId, const std::vector<int>& roots, int node, XmlNode from);

    int nearestCommonAncestor(int a, int b) const;  // kNoParent: only the scene itself

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
    std::size_t indexed_ = 0;
};

}  // namespace walkcycle
