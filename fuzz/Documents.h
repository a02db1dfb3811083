#pragma once

#include <optional>
#include <string>
#include <vector>

#include "loaders/document/XmlNode.h"
#include "walkcycle/loaders/LoadOptions.h"

// What the targets share that look into a document.
namespace walkcycle {

// Nothing outside the fuzzer's input is read.
inline LoadOptions withoutFiles() {
    LoadOptions options;
    options.resolver = [](const std::string&) -> std::optional<Bytes> { return std::nullopt; };
    return options;
}

// The element and all below it, in document order.
inline std::vector<XmlNode> elementsOf(XmlNode root) {
    std::vector<XmlNode> all;
    if (root) all.push_back(root);
    for (XmlNode element : root.descendants()) all.push_back(element);
    return all;
}

}  // namespace walkcycle
