#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "loaders/context/LoadContext.h"

namespace walkcycle {

// The document's <animation> tree, flattened: all channels in document order, and which of them belong to an
// <animation> (with those nested in it).
struct AnimationTree {
    std::vector<XmlNode> channels;
    std::unordered_map<XmlNode, std::pair<int, int>> channelsOf;  // <animation> -> first, one past the last
};

AnimationTree readAnimationTree(XmlNode collada);

// An <animation_clip>.
struct ClipRange {
    std::string name;
    double start = 0.0;
    std::optional<double> end;                  // none: when its animations end
    std::vector<std::pair<int, int>> channels;  // ranges of AnimationTree::channels

    bool plays(int channel) const;
};

std::vector<ClipRange> readClips(XmlNode collada, const AnimationTree& tree, const LoadContext& context);

// Whether two channels ever play together, given the clips: always where a document has none.
bool playTogether(const std::vector<ClipRange>& clips, int a, int b);

}  // namespace walkcycle
