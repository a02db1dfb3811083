#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"
#include "loaders/document/XmlTree.h"
#include "loaders/text/NumberText.h"
#include "walkcycle/io/Bytes.h"
#include "walkcycle/loaders/LoadLimits.h"

namespace tinyxml2 {
class XMLDocument;
}

namespace walkcycle {

class LoadProgress;

// One parsed document, with an index of its elements by id.
class ColladaDocument {
public:
    // Throws LoadError if the document cannot be parsed. Reports to `progress`, if there is one, after each step.
    ColladaDocument(Bytes bytes, std::string file, const LoadLimits& limits, Diagnostics& diagnostics,
                    LoadProgress* progress = nullptr);
    ~ColladaDocument();

    ColladaDocument(const ColladaDocument&) = delete;  // its nodes point to it
    ColladaDocument& operator=(const ColladaDocument&) = delete;

    const std::string& file() const { return tree_.file; }
    XmlNode root() const { return root_; }
    XmlNode byId(std::string_view id) const { return root_.elementById(id); }

private:
    void decode(Bytes bytes, Diagnostics& diagnostics);
    void parse(Diagnostics& diagnostics);
    bool placeNumberText();
    void indexElements(Diagnostics& diagnostics);

    XmlTree tree_;
    Bytes bytes_;            // as read; empty if they had to be decoded or changed
    std::string rewritten_;  // then this is the text
    std::string_view text_;  // UTF-8: a view of one of the two; the cut-out texts are views of it
    std::vector<std::optional<NumberText>> cutTexts_;  // attached to their elements as user data
    std::unique_ptr<tinyxml2::XMLDocument> xml_;
    XmlNode root_;
};

}  // namespace walkcycle
