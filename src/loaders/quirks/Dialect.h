#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "loaders/document/XmlNode.h"
#include "loaders/quirks/Quirks.h"

namespace walkcycle {

class Diagnostics;
struct LoadOptions;

// The exporter that an <authoring_tool> names, and its version where one follows the name.
struct Exporter {
    Tool tool = Tool::Unknown;
    std::optional<ToolVersion> version;
};
Exporter exporterOf(std::string_view authoringTool);

// Whether the exporter is that tool, in one of those versions. Without a version it is in no range that has bounds.
bool isIn(const Exporter& exporter, const ToolRange& range);

// How one document's exporter writes COLLADA: which quirks the document is read with.
class Dialect {
public:
    // LoadOptions::quirks and skinNode decide first; for all other quirks the tool decides.
    Dialect(std::string authoringTool, const LoadOptions& options);

    const std::string& authoringTool() const { return authoringTool_; }  // as the document writes it
    const Exporter& exporter() const { return exporter_; }
    bool follows(Quirk quirk) const { return stateOf(quirk).on; }
    bool isUsed(Quirk quirk) const {
        return stateOf(quirk).used;
    }                                    // the quirk changed how the document was read
    std::string why(Quirk quirk) const;  // "for ColladaMaya", "where the file shows it", "as chosen"

private:
    friend class Dialects;
    struct State {
        bool on = false, chosen = false, used = false;
    };
    const State& stateOf(Quirk quirk) const { return states_[static_cast<std::size_t>(quirk)]; }

    std::string authoringTool_;
    Exporter exporter_;
    std::array<State, kQuirkCount> states_{};
};

// The dialects of the documents of one load, each read once from the document's <asset>.
class Dialects {
public:
    Dialects(const LoadOptions& options, Diagnostics& diagnostics)
        : options_(options), diagnostics_(diagnostics) {}

    // The dialect of the document that the element stands in.
    const Dialect& of(const XmlNode& element) { return entryOf(element); }
    bool follows(Quirk quirk, const XmlNode& element) { return of(element).follows(quirk); }

    // To be called when a quirk changes how the file is read. Reports it once per document as WC0120, unless the quirk has
    // another code (QuirkInfo::code), which the caller reports.
    void note(Quirk quirk, const XmlNode& where);

private:
    Dialect& entryOf(const XmlNode& element);

    const LoadOptions& options_;
    Diagnostics& diagnostics_;
    std::unordered_map<XmlNode, Dialect> byDocument_;  // by root element
};

}  // namespace walkcycle
