#pragma once

#include "loaders/LoadOptions.h"
#include "loaders/XmlNode.h"

// What the targets share that look into a document.
namespace walkcycle {

// Nothing outside the fuzzer's input is read.
inline LoadOptions withoutFiles() {
    LoadOptions options;
    options.resolver = [](const std::string&) -> std::optional<Bytes> { return std::nullopt; };
    return options;
}

// The element after this one, in document order.
inline XmlNode next(XmlNode node) {
    if (const XmlNode child = node.firstChild()) return child;
    for (; node; node = node.parent())
        if (const XmlNode sibling = node.nextSibling()) return sibling;
    return {};
}

}  // namespace walkcycle
