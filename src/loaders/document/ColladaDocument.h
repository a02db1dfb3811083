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

// One parsed document: its elements by id.
class ColladaDocument {
public:
    // `progress`, where there is one, is told of the steps of the parsing.
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
    Bytes bytes_;            // as read,
    std::string rewritten_;  // or what was made of them, where they were not fit for use:
    std::string_view text_;  // UTF-8; what the cut-out texts are views of
    std::vector<std::optional<NumberText>> cutTexts_;  // hung on their elements as tinyxml2 user data
    std::unique_ptr<tinyxml2::XMLDocument> xml_;
    XmlNode root_;
};

}  // namespace walkcycle
