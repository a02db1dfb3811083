#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "profiles/Rules.h"

// Rules from the functions LoadAnimations and LoadAnimationSet of Gazebo's loader. GazeboRules.cpp has its address.
namespace walkcycle {
namespace {

bool showsSkin(const Subject& subject) {
    return std::any_of(subject.shown().begin(), subject.shown().end(),
                       [](const ShownMesh& shown) { return static_cast<bool>(shown.skin()); });
}

// The channels that Gazebo reads: those of one level of the first <library_animations>. If the first <animation> has
// children of its kind, it is the second level, otherwise the first.
std::vector<XmlNode> channelsRead(XmlNode library) {
    std::vector<XmlNode> channels;
    const auto addChannelsOf = [&](XmlNode parent) {
        for (const XmlNode animation : parent.children("animation"))
            for (const XmlNode channel : animation.children("channel")) channels.push_back(channel);
    };
    if (!library.child("animation").child("animation")) {
        addChannelsOf(library);
    } else {
        for (const XmlNode animation : library.children("animation")) addChannelsOf(animation);
    }
    return channels;
}

// Gazebo animates <matrix> and <rotate>. It drops the sids of other transform elements, so that no channel finds them.
void checkTarget(const Subject& subject, XmlNode channel) {
    const ChannelTarget target = subject.targetOf(channel);
    if (target.root.is("node") && isOneOf(target.element, {"translate", "scale", "lookat", "skew"}))
        subject.report(Code::GazeboTargetIgnored, channel,
                       {std::string(target.element.name()), nameOf(target.root)});
}

// At a key time that only some channels of a node have, Gazebo resets the values of its other channels to the rest
// pose.
void checkKeyTimes(const Subject& subject, const std::vector<XmlNode>& channels) {
    // <node> -> the <source> of its first channel's key times
    std::unordered_map<XmlNode, XmlNode> firstTimes;
    for (const XmlNode channel : channels) {
        const XmlNode node = subject.targetOf(channel).root;
        const XmlNode times = subject.sourceOf(subject.follow(channel, "source"), "INPUT");
        if (!node.is("node") || !times) continue;
        const auto [first, isNew] = firstTimes.try_emplace(node, times);
        if (isNew || first->second == times) continue;
        if (subject.contents(first->second.child("float_array")) !=
            subject.contents(times.child("float_array")))
            subject.report(Code::GazeboKeyTimes, channel, {nameOf(node)});
    }
}

void checkInterpolation(const Subject& subject, const std::vector<XmlNode>& channels) {
    std::unordered_set<XmlNode> seen;
    for (const XmlNode channel : channels) {
        const XmlNode sampler = subject.follow(channel, "source");
        const XmlNode names = subject.sourceOf(sampler, "INTERPOLATION").child("Name_array");
        if (!names || !seen.insert(names).second) continue;
        const std::vector<std::string> words = wordsOf(names);
        const auto curves = std::count_if(words.begin(), words.end(),
                                          [](const std::string& word) { return word != "LINEAR"; });
        if (curves > 0) subject.report(Code::GazeboInterpolation, names, {std::to_string(curves)});
    }
}

}  // namespace

void checkGazeboMotion(const Subject& subject) {
    const XmlNode library = subject.collada().child("library_animations");
    for (const XmlNode clip : subject.all("animation_clip"))
        subject.report(Code::GazeboClips, clip, {nameOf(clip)});
    if (!library) return;
    if (!showsSkin(subject)) {
        if (library.child("animation")) subject.report(Code::GazeboRigidAnimation, library, {});
        return;
    }
    if (!library.child("animation")) return subject.report(Code::GazeboEmptyAnimations, library, {});
    const std::vector<XmlNode> channels = channelsRead(library);
    const std::unordered_set<XmlNode> read(channels.begin(), channels.end());
    for (const XmlNode channel : subject.all("channel"))
        if (!read.contains(channel))
            subject.report(Code::GazeboChannelDepth, channel, {std::string(channel.attribute("target"))});
    for (const XmlNode channel : channels) checkTarget(subject, channel);
    checkKeyTimes(subject, channels);
    checkInterpolation(subject, channels);
}

}  // namespace walkcycle
