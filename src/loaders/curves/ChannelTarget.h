#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "loaders/document/XmlNode.h"

namespace walkcycle {

// The target of a <channel> (COLLADA 1.4.1, chapter 3, "Address Syntax"): "node/sid", "node/child/sid.X",
// "node/matrix(3)(0)", "weights(2)". The end may be a member or index, or a part of the name: ids and sids
// may contain dots and parentheses.
struct ChannelTarget {
    XmlNode root;              // the element with the id; nothing if there is none
    XmlNode element;           // the element that the target names; nothing if there is none
    std::string lookedFor;     // the first id or sid that was not found, for messages
    std::string member;        // "X", "ANGLE", ...; empty if there is none
    std::vector<int> indices;  // one for "(i)", two for "(i)(j)"; otherwise empty
};

// Finds elements by sid. It indexes what is below an element once, because channels search the same elements
// again and again.
class SidFinder {
public:
    // The nearest element below `from` with that sid, searched breadth first, as the specification demands.
    XmlNode find(XmlNode from, std::string_view sid);

private:
    using BySid = std::unordered_map<std::string_view, XmlNode>;
    std::unordered_map<XmlNode, BySid> below_;
};

// Resolves the `target` of a <channel>. Reports nothing.
ChannelTarget findTarget(XmlNode channel, SidFinder& sids);

// The index of the number that a member names: 0 for X, R, U and S, 3 for ANGLE and A, ... Nothing for an
// unknown member.
std::optional<int> memberIndex(std::string_view member);

// The nearest ancestor of `node` with that name, or `node` itself; nothing if there is none.
XmlNode enclosing(XmlNode node, std::string_view elementName);

}  // namespace walkcycle
