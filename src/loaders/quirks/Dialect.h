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

// True if the exporter is that tool, in one of those versions. An exporter without a version is in no bounded range.
bool isIn(const Exporter& exporter, const ToolRange& range);

// How one document's exporter writes COLLADA: which quirks the document is read with.
class Dialect {
public:
    // What the options choose counts, and then the tool.
    Dialect(std::string authoringTool, const LoadOptions& options);

    const std::string& authoringTool() const { return authoringTool_; }  // as the document writes it
    const Exporter& exporter() const { return exporter_; }
    bool follows(Quirk quirk) const { return stateOf(quirk).on; }
    bool isUsed(Quirk quirk) const { return stateOf(quirk).used; }  // it changed how the document was read
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
    // Throws std::invalid_argument where the options name a quirk that does not exist.
    Dialects(const LoadOptions& options, Diagnostics& diagnostics)
        : options_(options), diagnostics_(diagnostics) {
        requireKnownQuirks(options);
    }

    // The dialect of the document that the element stands in.
    const Dialect& of(const XmlNode& element) { return entryOf(element); }
    bool follows(Quirk quirk, const XmlNode& element) { return of(element).follows(quirk); }

    // To be called where a quirk changes how the file is read. Reports that once per document, unless the caller does
    // with a code of its own (see QuirkInfo::code).
    void note(Quirk quirk, const XmlNode& where);

    // Throws std::invalid_argument as the constructor does.
    static void requireKnownQuirks(const LoadOptions& options);

private:
    Dialect& entryOf(const XmlNode& element);

    const LoadOptions& options_;
    Diagnostics& diagnostics_;
    std::unordered_map<XmlNode, Dialect> byDocument_;  // by its root
};

// "there is no quirk 'spaced-name'; perhaps 'spaced-names' is meant", for a name that findQuirk() does not know.
std::string unknownQuirk(std::string_view name);

}  // namespace walkcycle
