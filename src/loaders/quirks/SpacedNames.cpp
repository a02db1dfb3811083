#include "loaders/quirks/SpacedNames.h"

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>

namespace walkcycle {
namespace {

constexpr std::size_t kMostWordsOfAName = 12;

bool mayHoldNodes(XmlNode element) {
    return element.is("library_visual_scenes") || element.is("library_nodes") || element.is("visual_scene") ||
           element.is("node");
}

// The sids, names and ids of all nodes.
std::unordered_set<std::string> namesOfNodes(XmlNode collada) {
    std::unordered_set<std::string> names;
    const XmlNode::Descendants elements = collada.descendants();
    for (auto element = elements.begin(); element != elements.end(); ++element) {
        if (!mayHoldNodes(*element)) element.skipChildren();
        if (!element->is("node")) continue;
        for (const char* attribute : {"sid", "name", "id"}) names.emplace(element->attribute(attribute));
    }
    return names;
}

}  // namespace

std::optional<std::vector<std::string>> joinSpacedNames(const std::vector<std::string_view>& words,
                                                        std::size_t count, XmlNode collada) {
    if (count == 0 || count >= words.size() || words.size() > count * kMostWordsOfAName) return std::nullopt;
    const std::unordered_set<std::string> known = namesOfNodes(collada);
    std::vector<std::string> names;
    for (std::size_t at = 0; at < words.size();) {
        std::string name(words[at]), longest;
        std::size_t end = at;
        for (std::size_t i = at; i < std::min(words.size(), at + kMostWordsOfAName); ++i) {
            if (i > at) name += ' ' + std::string(words[i]);
            if (known.contains(name)) longest = name, end = i + 1;
        }
        if (end == at || names.size() == count) return std::nullopt;
        names.push_back(std::move(longest));
        at = end;
    }
    return names.size() == count ? std::optional(std::move(names)) : std::nullopt;
}

}  // namespace walkcycle
