#include "loaders/curves/ClipLoader.h"

#include <algorithm>

#include "loaders/text/NumberParser.h"

namespace walkcycle {

namespace {

// Reads the <instance_animation>s of an <animation_clip>. Those that refer to no <animation> are reported.
void readInstances(XmlNode element, const AnimationTree& tree, const LoadContext& context, ClipRange& clip) {
    for (XmlNode instance : element.children("instance_animation")) {
        const XmlNode animation = context.documents.follow(instance, "url", "animation");
        if (const auto found = tree.channelsOf.find(animation); animation && found != tree.channelsOf.end())
            clip.channels.push_back(found->second);
    }
    if (clip.channels.empty())
        context.diagnostics.report(Code::ClipIncomplete, element,
                                   {clip.name, "names no animation that is there"});
}

std::optional<double> readTime(XmlNode element, const char* attribute, const std::string& clip,
                               const LoadContext& context) {
    double seconds = 0.0;
    if (!element.has(attribute)) return std::nullopt;
    if (parseNumber(element.attribute(attribute), seconds)) return seconds;
    context.diagnostics.report(Code::ClipIncomplete, element,
                               {clip, std::string("has no usable ") + attribute});
    return std::nullopt;
}

}  // namespace

AnimationTree readAnimationTree(XmlNode collada) {
    AnimationTree tree;
    for (XmlNode library : collada.children("library_animations")) {
        const XmlNode::Descendants elements = library.descendants();
        std::vector<XmlNode> open;  // the <animation>s around the current element, outermost first
        const auto closeBelow = [&](int depth) {
            while (static_cast<int>(open.size()) >= depth) {
                tree.channelsOf[open.back()].second = static_cast<int>(tree.channels.size());
                open.pop_back();
            }
        };
        for (auto element = elements.begin(); element != elements.end(); ++element) {
            closeBelow(element.depth());
            if (element->is("channel")) tree.channels.push_back(*element);
            if (!element->is("animation")) {
                element.skipChildren();
                continue;
            }
            const int reached = static_cast<int>(tree.channels.size());
            tree.channelsOf[*element] = {reached, reached};
            open.push_back(*element);
        }
        closeBelow(1);
    }
    return tree;
}

bool ClipRange::plays(int channel) const {
    return std::any_of(channels.begin(), channels.end(), [&](const std::pair<int, int>& range) {
        return channel >= range.first && channel < range.second;
    });
}

std::vector<ClipRange> readClips(XmlNode collada, const AnimationTree& tree, const LoadContext& context) {
    std::vector<ClipRange> clips;
    for (XmlNode library : collada.children("library_animation_clips"))
        for (XmlNode element : library.children("animation_clip")) {
            ClipRange clip;
            clip.name = element.attribute("name");
            if (clip.name.empty()) clip.name = element.id();
            if (clip.name.empty()) clip.name = "clip " + std::to_string(clips.size() + 1);
            clip.start = readTime(element, "start", clip.name, context).value_or(0.0);
            clip.end = readTime(element, "end", clip.name, context);
            if (clip.end && *clip.end < clip.start) {
                context.diagnostics.report(Code::ClipIncomplete, element,
                                           {clip.name, "ends before it starts"});
                clip.end.reset();
            }
            readInstances(element, tree, context, clip);
            if (!clip.channels.empty()) clips.push_back(std::move(clip));
        }
    return clips;
}

bool playTogether(const std::vector<ClipRange>& clips, int a, int b) {
    bool apart = false;
    for (const ClipRange& clip : clips) {
        const bool hasA = clip.plays(a), hasB = clip.plays(b);
        if (hasA && hasB) return true;
        apart = apart || hasA || hasB;
    }
    return !apart;
}

}  // namespace walkcycle
