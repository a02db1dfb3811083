#include "loaders/document/XmlNode.h"

#include <algorithm>
#include <vector>

#include <tinyxml2.h>

#include "io/TextScan.h"
#include "loaders/text/NumberText.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

std::string_view localName(const char* qualified) {
    const std::string_view name(qualified);
    const std::size_t colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

int lineBreaks(std::string_view text) {
    return static_cast<int>(countLineBreaks(text));
}

// A step of path(): "geometry[id=body]", "node[sid=hip]", or the plain name.
std::string step(const XmlNode& node) {
    std::string text(node.name());
    if (!node.id().empty()) return text + "[id=" + printable(node.id()) + "]";
    if (!node.sid().empty()) return text + "[sid=" + printable(node.sid()) + "]";
    return text;
}

bool isPlainText(const tinyxml2::XMLNode* node) {
    return node->ToText() && !node->ToText()->CData();
}

// Calls use(piece, apart) for each piece of an element's text. `apart` says that the piece begins a new word: comments, CDATA
// and processing instructions do not end a word, but elements do. So do two neighbours that are not plain text, since
// tinyxml2 drops white space between them.
template <typename Use>
void forEachPiece(const tinyxml2::XMLElement* element, Use use) {
    bool apart = false;
    for (auto* node = element ? element->FirstChild() : nullptr; node; node = node->NextSibling()) {
        const tinyxml2::XMLNode* before = node->PreviousSibling();
        apart = apart || node->ToElement() || (before && !isPlainText(before) && !isPlainText(node));
        if (!node->ToText()) continue;
        use(*node->ToText(), apart);
        apart = false;
    }
}

// The element's text, if it was cut out of the document before parsing (see NumberText.h); otherwise null.
const NumberText* cutText(const tinyxml2::XMLElement* element) {
    return element ? static_cast<const NumberText*>(element->GetUserData()) : nullptr;
}

}  // namespace

std::string_view XmlNode::name() const {
    if (!element_) return {};
    return tree_->hasPrefixes ? localName(element_->Name()) : element_->Name();
}

bool XmlNode::is(std::string_view elementName) const {
    return element_ && name() == elementName;
}

bool XmlNode::has(const char* attributeName) const {
    return element_ && element_->Attribute(attributeName);
}

std::string_view XmlNode::attribute(const char* attributeName) const {
    const char* value = element_ ? element_->Attribute(attributeName) : nullptr;
    return value ? std::string_view(value) : std::string_view();
}

XmlNode XmlNode::root() const {
    return element_ ? XmlNode(element_->GetDocument()->RootElement(), tree_) : XmlNode();
}

XmlNode XmlNode::elementById(std::string_view id) const {
    if (!tree_) return {};
    const auto found = tree_->byId.find(id);
    return found == tree_->byId.end() ? XmlNode() : XmlNode(found->second, tree_);
}

XmlNode XmlNode::parent() const {
    const tinyxml2::XMLNode* up = element_ ? element_->Parent() : nullptr;
    return up && up->ToElement() ? XmlNode(up->ToElement(), tree_) : XmlNode();
}

XmlNode XmlNode::firstChild() const {
    const tinyxml2::XMLElement* found = element_ ? element_->FirstChildElement() : nullptr;
    return found ? XmlNode(found, tree_) : XmlNode();
}

XmlNode XmlNode::nextSibling() const {
    const tinyxml2::XMLElement* found = element_ ? element_->NextSiblingElement() : nullptr;
    return found ? XmlNode(found, tree_) : XmlNode();
}

XmlNode XmlNode::child(std::string_view elementName) const {
    const XmlNode first = firstChild();
    return !first || first.is(elementName) ? first : first.nextSibling(elementName);
}

XmlNode XmlNode::nextSibling(std::string_view elementName) const {
    XmlNode sibling = nextSibling();
    while (sibling && !sibling.is(elementName)) sibling = sibling.nextSibling();
    return sibling;
}

XmlNode::Range XmlNode::children(std::string_view elementName) const {
    return {elementName.empty() ? firstChild() : child(elementName), elementName};
}

XmlNode::Descendants XmlNode::descendants() const {
    return Descendants(firstChild());
}

// Uses tinyxml2's pointers, for speed: several walks visit every element of a document.
XmlNode::Descendants::Iterator& XmlNode::Descendants::Iterator::operator++() {
    const tinyxml2::XMLElement* next = entersChildren_ ? node_.element_->FirstChildElement() : nullptr;
    if (next) ++depth_;
    entersChildren_ = true;
    for (const tinyxml2::XMLNode* from = node_.element_; !next; from = from->Parent()) {
        next = from->NextSiblingElement();
        if (!next && --depth_ == 0) break;
    }
    node_ = next ? XmlNode(next, node_.tree_) : XmlNode();
    return *this;
}

std::string_view XmlNode::rawText(std::string& joined) const {
    const tinyxml2::XMLText* only = nullptr;
    joined.clear();
    if (const NumberText* cut = cutText(element_)) return cut->text;
    int pieces = 0;
    forEachPiece(element_, [&](const tinyxml2::XMLText& text, bool apart) {
        if (++pieces == 1) {
            only = &text;
            return;
        }
        if (pieces == 2) joined = only->Value();
        joined.append(apart ? " " : "").append(text.Value());
    });
    if (pieces == 0) return {};
    return pieces == 1 ? std::string_view(only->Value()) : std::string_view(joined);
}

// tinyxml2 gives the line of a text's first character that is not white space.
int XmlNode::textLine(std::size_t offset) const {
    if (const NumberText* cut = cutText(element_))
        return line() + cut->linesInTag + lineBreaks(cut->text.substr(0, offset));
    int found = line();
    bool isFound = false, isFirst = true;
    forEachPiece(element_, [&](const tinyxml2::XMLText& node, bool apart) {
        if (isFound) return;
        if (apart && !isFirst && offset > 0) --offset;  // the space that rawText puts there
        isFirst = false;
        const std::string_view text(node.Value());
        const std::size_t first = node.CData() ? 0 : text.find_first_not_of(" \t\r\n\v\f");
        found = node.GetLineNum() - lineBreaks(text.substr(0, first)) + lineBreaks(text.substr(0, offset));
        isFound = offset <= text.size();
        offset -= std::min(offset, text.size());
    });
    return found;
}

int XmlNode::lineOfWord(std::size_t n) const {
    std::string joined;
    const std::size_t start = startOfWord(rawText(joined), n);
    return start == std::string_view::npos ? line() : textLine(start);
}

std::string XmlNode::text() const {
    std::string joined;
    return std::string(trim(rawText(joined)));
}

int XmlNode::line() const {
    return element_ ? element_->GetLineNum() : 0;
}

std::vector<std::pair<std::string_view, std::string_view>> XmlNode::attributes() const {
    std::vector<std::pair<std::string_view, std::string_view>> all;
    for (auto* attribute = element_ ? element_->FirstAttribute() : nullptr; attribute;
         attribute = attribute->Next())
        all.emplace_back(attribute->Name(), attribute->Value());
    return all;
}

int XmlNode::commentLine() const {
    for (auto* node = element_ ? element_->FirstChild() : nullptr; node; node = node->NextSibling())
        if (node->ToComment()) return node->GetLineNum();
    return 0;
}

std::string XmlNode::path() const {
    std::vector<std::string> steps;
    for (XmlNode node = *this; node; node = node.parent()) steps.push_back(step(node));
    std::string path;
    for (auto it = steps.rbegin(); it != steps.rend(); ++it) path += (path.empty() ? "" : "/") + *it;
    return path;
}

const std::string& XmlNode::file() const {
    static const std::string kNone;
    return tree_ ? tree_->file : kNone;
}

XmlNode::operator FileLocation() const {
    return {file(), line(), path(), std::string(name())};
}

}  // namespace walkcycle
