#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "loaders/context/LoadContext.h"

namespace walkcycle {

// The <animation> tree of a document, flattened: all channels in document order. An <animation>, with those
// nested in it, has a range of them.
struct AnimationTree {
    std::vector<XmlNode> channels;
    // <animation> -> indices of its first channel and after its last.
    std::unordered_map<XmlNode, std::pair<int, int>> channelsOf;
};

AnimationTree readAnimationTree(XmlNode collada);

// An <animation_clip> (COLLADA 1.4.1, chapter 5). Times are seconds of the timeline of the document.
struct ClipRange {
    std::string name;
    double start = 0.0;
    std::optional<double> end;                  // empty: the end of its animations
    std::vector<std::pair<int, int>> channels;  // ranges of AnimationTree::channels

    bool plays(int channel) const;  // `channel`: an index into AnimationTree::channels
};

// Reads the <animation_clip>s. Clips without an <animation> are reported and left out.
std::vector<ClipRange> readClips(XmlNode collada, const AnimationTree& tree, const LoadContext& context);

// Whether two channels play at the same time: in one clip, or because no clip plays either of them. Always
// true without clips.
bool playTogether(const std::vector<ClipRange>& clips, int a, int b);

}  // namespace walkcycle
