#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "loaders/document/FileLocation.h"
#include "loaders/document/XmlTree.h"

namespace walkcycle {

// An element of the document, or nothing: a missing child is an XmlNode that converts to false. Its children are missing,
// too, and its attributes empty, so that a path of optional children needs no checks on the way.
// (The series' XmlNode, on tinyxml2. It is two pointers: copy it freely; the document must outlive it.)
class XmlNode {
public:
    XmlNode() = default;
    XmlNode(const tinyxml2::XMLElement* element, const XmlTree* tree) : element_(element), tree_(tree) {}

    explicit operator bool() const { return element_ != nullptr; }
    bool operator==(const XmlNode& other) const { return element_ == other.element_; }

    std::string_view name() const;  // without a namespace prefix
    bool is(std::string_view elementName) const;
    bool has(const char* attributeName) const;
    std::string_view attribute(const char* attributeName) const;  // empty if it is missing
    std::string_view id() const { return attribute("id"); }
    std::string_view sid() const { return attribute("sid"); }

    XmlNode root() const;                            // of the node's own document
    XmlNode elementById(std::string_view id) const;  // in the node's own document
    XmlNode parent() const;
    XmlNode child(std::string_view elementName) const;  // the first of that name
    XmlNode firstChild() const;                         // of any name
    XmlNode nextSibling() const;                        // of any name
    XmlNode nextSibling(std::string_view elementName) const;

    // for (XmlNode input : mesh.children("input")); an empty name means every child.
    class Range;
    Range children(std::string_view elementName = {}) const;

    // for (XmlNode element : collada.descendants()): every element below this one, in document order, each before its own
    // children. Does not recurse, since a file may nest its elements deeply.
    class Descendants;
    Descendants descendants() const;

    // The element's text without white space at its ends. Comments within it are left out.
    std::string text() const;
    // The same untrimmed. Not copied if the text is in one piece; otherwise `joined` holds it.
    std::string_view rawText(std::string& joined) const;
    // The line of a character of rawText(); the element's line if it has no text.
    int textLine(std::size_t offset = 0) const;
    // The line of word n of the text, counted from 0; the element's line if there is no such word.
    int lineOfWord(std::size_t n) const;

    // Names and values, in order.
    std::vector<std::pair<std::string_view, std::string_view>> attributes() const;

    int line() const;
    int commentLine() const;   // of the first comment among the element's children; 0 if there is none
    std::string path() const;  // "COLLADA/library_geometries/geometry[id=body]/mesh"
    const std::string& file() const;
    operator FileLocation() const;  // NOLINT: so that an element can be passed as a message's place
    const tinyxml2::XMLElement* element() const { return element_; }

private:
    const tinyxml2::XMLElement* element_ = nullptr;
    const XmlTree* tree_ = nullptr;
};

class XmlNode::Range {
public:
    class Iterator {
    public:
        using value_type = XmlNode;
        using difference_type = std::ptrdiff_t;
        Iterator(XmlNode node, std::string_view name) : node_(node), name_(name) {}
        XmlNode operator*() const { return node_; }
        Iterator& operator++() {
            node_ = name_.empty() ? node_.nextSibling() : node_.nextSibling(name_);
            return *this;
        }
        bool operator!=(const Iterator& other) const { return !(node_ == other.node_); }

    private:
        XmlNode node_;
        std::string_view name_;
    };
    Range(XmlNode first, std::string_view name) : first_(first), name_(name) {}
    Iterator begin() const { return {first_, name_}; }
    Iterator end() const { return {{}, name_}; }

private:
    XmlNode first_;
    std::string_view name_;
};

class XmlNode::Descendants {
public:
    class Iterator {
    public:
        using value_type = XmlNode;
        using difference_type = std::ptrdiff_t;
        explicit Iterator(XmlNode first) : node_(first) {}
        XmlNode operator*() const { return node_; }
        const XmlNode* operator->() const { return &node_; }
        Iterator& operator++();
        bool operator!=(const Iterator& other) const { return !(node_ == other.node_); }

        int depth() const { return depth_; }              // 1 for children, 2 for their children
        void skipChildren() { entersChildren_ = false; }  // of the current element

    private:
        XmlNode node_;
        int depth_ = 1;
        bool entersChildren_ = true;
    };
    explicit Descendants(XmlNode first) : first_(first) {}
    Iterator begin() const { return Iterator(first_); }
    Iterator end() const { return Iterator({}); }

private:
    XmlNode first_;
};

}  // namespace walkcycle

template <>
struct std::hash<walkcycle::XmlNode> {
    std::size_t operator()(const walkcycle::XmlNode& node) const noexcept {
        return std::hash<const void*>()(node.element());
    }
};
