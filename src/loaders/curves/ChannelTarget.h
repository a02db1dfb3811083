#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "loaders/document/XmlNode.h"

namespace walkcycle {

// What a <channel target="..."> says: "node/sid", "node/child/sid.X", "node/matrix(3)(0)", "weights(2)".
// The end of the string may be a member or part of a name, as ids and sids may hold dots (and parentheses).
struct ChannelTarget {
    XmlNode root;              // the element that the target's id names; nothing where there is none
    XmlNode element;           // what root and the sids lead to; nothing where they lead nowhere
    std::string lookedFor;     // where they lead nowhere: what is not there
    std::string member;        // "X", "ANGLE", ...; empty where the target ends with an index or nothing
    std::vector<int> indices;  // of "(i)" or "(i)(j)"
};

// Finds elements by sid, below elements that are asked for again and again.
class SidFinder {
public:
    // The nearest element below `from` with that sid, level by level, as the specification searches.
    XmlNode find(XmlNode from, std::string_view sid);

private:
    using BySid = std::unordered_map<std::string_view, XmlNode>;
    std::unordered_map<XmlNode, BySid> below_;
};

ChannelTarget findTarget(XmlNode channel, SidFinder& sids);

// Which of an element's numbers a member means: 0 for X, R, U, S, 3 for ANGLE and A, ... Nothing for an unknown one.
std::optional<int> memberIndex(std::string_view member);

// The nearest element around `node`, itself included, with that name.
XmlNode enclosing(XmlNode node, std::string_view elementName);

}  // namespace walkcycle
