#include "loaders/curves/ChannelTarget.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "loaders/text/NumberParser.h"
#include "loaders/text/Words.h"

namespace walkcycle {

namespace {

// The last name of a target, and a member or indices cut off from its end.
struct Ending {
    std::string_view name, member;
    std::vector<int> indices;
};

std::optional<Ending> cutIndices(std::string_view text) {
    Ending ending;
    while (text.ends_with(')')) {
        const std::size_t open = text.rfind('(');
        std::int32_t index = 0;
        if (open == text.npos || !parseNumber(text.substr(open + 1, text.size() - open - 2), index) ||
            index < 0)
            break;
        ending.indices.insert(ending.indices.begin(), index);
        text = text.substr(0, open);
    }
    ending.name = text;
    if (ending.indices.empty() || ending.indices.size() > 2) return std::nullopt;
    return ending;
}

// The possible readings of the last name, the most literal first.
std::vector<Ending> readings(std::string_view last) {
    std::vector<Ending> all{{last, {}, {}}};
    if (auto indexed = cutIndices(last)) all.push_back(std::move(*indexed));
    if (const std::size_t dot = last.rfind('.'); dot != last.npos)
        all.push_back({last.substr(0, dot), last.substr(dot + 1), {}});
    return all;
}

std::vector<std::string_view> splitPath(std::string_view text) {
    std::vector<std::string_view> names;
    for (std::size_t slash; (slash = text.find('/')) != text.npos; text = text.substr(slash + 1))
        names.push_back(text.substr(0, slash));
    names.push_back(text);
    return names;
}

}  // namespace

// Fast path: nearly always, the sid is that of one of the first children. For others, the descendants are
// indexed once.
XmlNode SidFinder::find(XmlNode from, std::string_view sid) {
    constexpr int kFirstChildren = 16;
    if (sid.empty()) return {};
    XmlNode child = from.firstChild();
    for (int i = 0; child && i < kFirstChildren; ++i, child = child.nextSibling())
        if (child.sid() == sid) return child;
    const auto [entry, isNew] = below_.try_emplace(from);
    if (isNew) {
        constexpr std::size_t kMostElements = 20'000;  // nested elements are indexed once per level
        std::vector<XmlNode> level{from};              // breadth first; XmlNode::descendants() is depth first
        for (std::size_t i = 0; i < level.size() && level.size() < kMostElements; ++i)
            for (XmlNode below : level[i].children()) {
                entry->second.try_emplace(below.sid(), below);
                level.push_back(below);
            }
    }
    const auto found = entry->second.find(sid);
    return found == entry->second.end() ? XmlNode() : found->second;
}

XmlNode enclosing(XmlNode node, std::string_view elementName) {
    while (node && !node.is(elementName)) node = node.parent();
    return node;
}

std::optional<int> memberIndex(std::string_view member) {
    static constexpr std::pair<std::string_view, int> kMembers[] = {
        {"X", 0}, {"Y", 1}, {"Z", 2}, {"W", 3}, {"ANGLE", 3}, {"R", 0}, {"G", 1}, {"B", 2},
        {"A", 3}, {"U", 0}, {"V", 1}, {"S", 0}, {"T", 1},     {"P", 2}, {"Q", 3}, {"TIME", 0}};
    for (const auto& [name, index] : kMembers)
        if (member == name) return index;
    return std::nullopt;
}

ChannelTarget findTarget(XmlNode channel, SidFinder& sids) {
    std::string_view text = trim(channel.attribute("target"));
    if (text.starts_with('#')) text.remove_prefix(1);
    const std::vector<std::string_view> names = splitPath(text);
    const auto byId = [&](std::string_view id) { return channel.elementById(id); };

    ChannelTarget target;
    if (names.size() == 1) {
        for (const Ending& ending : readings(text))
            if ((target.element = target.root = byId(ending.name))) {
                target.member = ending.member;
                target.indices = ending.indices;
                return target;
            }
        target.lookedFor = "element with id '" + std::string(text) + "'";
        return target;
    }
    target.root = byId(names.front());
    if (!target.root) {
        target.lookedFor = "element with id '" + std::string(names.front()) + "'";
        return target;
    }
    XmlNode holder = target.root;
    for (std::size_t i = 1; i + 1 < names.size() && holder; ++i) {
        target.lookedFor = "sid '" + std::string(names[i]) + "' below <" + std::string(holder.name()) + ">";
        holder = sids.find(holder, names[i]);
    }
    for (const Ending& ending : readings(names.back())) {
        target.member = ending.member;
        target.indices = ending.indices;
        if (holder && (target.element = sids.find(holder, ending.name))) return target;
        if (holder)
            target.lookedFor =
                "sid '" + std::string(ending.name) + "' below <" + std::string(holder.name()) + ">";
    }
    return target;
}

}  // namespace walkcycle
