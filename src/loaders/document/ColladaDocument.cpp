#include "loaders/document/ColladaDocument.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <tinyxml2.h>

#include "io/TextEncoding.h"
#include "io/TextScan.h"
#include "loaders/document/LimitCheck.h"
#include "loaders/document/LoadProgress.h"
#include "loaders/text/Markup.h"

namespace walkcycle {
namespace {

int lineAt(std::string_view text, std::size_t offset) {
    return 1 + static_cast<int>(countLineBreaks(text.substr(0, offset)));
}

std::string toText(Bytes bytes, const std::string& file, Diagnostics& diagnostics) {
    if (bytes.empty()) diagnostics.fail(Code::NotXml, file, 1, {"the file is empty"});
    try {
        bool guessed = false, padded = false;
        std::string text = toUtf8(std::move(bytes), &guessed, &padded);
        if (guessed) diagnostics.report(Code::EncodingGuessed, file, lineAt(text, findBeyondAscii(text)), {});
        if (padded) diagnostics.report(Code::ControlCharacter, file, lineAt(text, text.size()), {});
        return text;
    } catch (const EncodingError& error) {
        diagnostics.fail(Code::BadEncoding, file, error.line, {error.what()});
    } catch (const std::runtime_error& error) {
        diagnostics.fail(Code::BadEncoding, file, 1, {error.what()});
    }
}

// The decoding has dropped zero bytes at the end.
void reportControls(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
    if (const std::size_t control = findForbiddenControl(text); control != text.size())
        diagnostics.report(Code::ControlCharacter, file, lineAt(text, control), {});
}

void refuseCrowdedTags(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
    const std::size_t crowded = findCrowdedTag(text, kMostAttributes);
    if (crowded == text.npos) return;
    diagnostics.fail(Code::NotXml, file, lineAt(text, crowded),
                     {"an element has more than " + std::to_string(kMostAttributes) + " attributes"});
}

// Fails if the document declares entities: tinyxml2 would skip the declarations without a word.
void refuseEntities(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
    const std::size_t root = text.find("<COLLADA");
    const std::size_t doctype = text.substr(0, root).find("<!DOCTYPE");
    if (doctype == text.npos) return;
    const std::size_t entity = text.find("<!ENTITY", doctype);
    if (entity < root) diagnostics.fail(Code::EntitiesRefused, file, lineAt(text, entity), {});
}

struct Reason {
    tinyxml2::XMLError error;
    const char* text;
};
constexpr Reason kReasons[] = {
    {tinyxml2::XML_ERROR_MISMATCHED_ELEMENT, "an element is not closed, or closed by another's end tag"},
    {tinyxml2::XML_ERROR_EMPTY_DOCUMENT, "there is no element in it"},
    {tinyxml2::XML_ERROR_PARSING_ATTRIBUTE, "an attribute is not written as name=\"value\""},
    {tinyxml2::XML_ERROR_PARSING_ELEMENT, "a tag is cut short or misspelt"},
    {tinyxml2::XML_ERROR_PARSING_TEXT, "the text ends before its element does"},
    {tinyxml2::XML_ERROR_PARSING_COMMENT, "a comment has no end"},
    {tinyxml2::XML_ERROR_PARSING_CDATA, "a CDATA section has no end"}};

std::string describe(tinyxml2::XMLError error) {
    for (const Reason& reason : kReasons)
        if (reason.error == error) return reason.text;
    return "the markup cannot be read";
}

}  // namespace

ColladaDocument::ColladaDocument(Bytes bytes, std::string file, const LoadLimits& limits,
                                 Diagnostics& diagnostics, LoadProgress* progress)
    : tree_{.file = std::move(file), .byId = {}}, xml_(std::make_unique<tinyxml2::XMLDocument>()) {
    requireWithin(limits, &LoadLimits::maxFileBytes, bytes.size(), tree_.file, 0, diagnostics);
    decode(std::move(bytes), diagnostics);
    requireFewElements(text_, tree_.file, limits, diagnostics);
    const std::size_t length = text_.size();
    if (progress) progress->documentIs(0.4);  // decoded
    parse(diagnostics);
    if (progress) progress->documentIs(0.9);  // parsed
    root_ = XmlNode(xml_->RootElement(), &tree_);
    if (!root_) diagnostics.fail(Code::NotXml, tree_.file, 1, {"there is no element in it"});
    if (const XmlNode second = root_.nextSibling())
        diagnostics.fail(Code::NotXml, second,
                         {"a second root element, <" + std::string(second.name()) + ">"});
    if (!root_.is("COLLADA")) diagnostics.fail(Code::NotCollada, root_, {std::string(root_.name())});
    requireModestElements(root_, length, limits, diagnostics);
    indexElements(diagnostics);
}

ColladaDocument::~ColladaDocument() = default;

// A document that is UTF-8 already, as nearly all are, is not copied.
void ColladaDocument::decode(Bytes bytes, Diagnostics& diagnostics) {
    bool isPlain = false;
    const std::optional<std::string_view> text = asUtf8(bytes, &isPlain);
    if (text && !text->empty()) {
        bytes_ = std::move(bytes);
        text_ = *text;
    } else {
        rewritten_ = toText(std::move(bytes), tree_.file, diagnostics);
        text_ = rewritten_;
    }
    if (!isPlain) reportControls(text_, tree_.file, diagnostics);
    refuseEntities(text_, tree_.file, diagnostics);
    if (std::optional<std::string> kept = withoutInstructions(text_)) {
        rewritten_ = std::move(*kept);
        bytes_ = {};
        text_ = rewritten_;
    }
}

// Parses the document without its long number lists if they can be cut out, otherwise as a whole.
void ColladaDocument::parse(Diagnostics& diagnostics) {
    if (std::optional<CutDocument> cut = cutNumberText(text_)) {
        xml_->Parse(cut->remaining.data(), cut->remaining.size());
        cutTexts_ = std::move(cut->texts);
        if (!xml_->Error() && placeNumberText()) return;
        cutTexts_.clear();
    }
    refuseCrowdedTags(text_, tree_.file, diagnostics);
    xml_->Parse(text_.data(), text_.size());
    if (xml_->ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED)
        diagnostics.fail(Code::TooDeep, tree_.file, xml_->ErrorLineNum(),
                         {std::to_string(limitInfo(&LoadLimits::maxNesting).most)});
    if (xml_->Error())
        diagnostics.fail(Code::NotXml, tree_.file, std::max(1, xml_->ErrorLineNum()),
                         {describe(xml_->ErrorID())});
    text_ = {};  // tinyxml2's tree has copied the text
    rewritten_ = {};
    bytes_ = {};
}

// Attaches each cut-out text to its element. Returns false if tinyxml2 found other elements than the cutter.
bool ColladaDocument::placeNumberText() {
    std::size_t next = 0;
    for (XmlNode node : XmlNode(xml_->RootElement(), &tree_).descendants()) {
        auto* const element = const_cast<tinyxml2::XMLElement*>(node.element());  // one of our xml_
        if (!holdsNumberText(element->Name())) continue;
        if (next == cutTexts_.size()) return false;
        std::optional<NumberText>& text = cutTexts_[next++];
        if (!text) continue;
        if (!element->NoChildren()) return false;
        element->SetUserData(&*text);
    }
    return next == cutTexts_.size();
}

void ColladaDocument::indexElements(Diagnostics& diagnostics) {
    bool hasPrefixes = false;
    const auto add = [&](XmlNode element) {
        hasPrefixes = hasPrefixes || std::strchr(element.element()->Name(), ':');
        const std::string_view id = element.id();
        if (id.empty()) return;
        const auto [first, isNew] = tree_.byId.try_emplace(id, element.element());
        if (!isNew)
            diagnostics.report(Code::DuplicateId, element,
                               {std::string(id), std::to_string(first->second->GetLineNum())});
    };
    add(root_);
    for (XmlNode element : root_.descendants()) add(element);
    tree_.hasPrefixes = hasPrefixes;
}

}  // namespace walkcycle
