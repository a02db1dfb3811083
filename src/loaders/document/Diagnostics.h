#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "loaders/document/FileLocation.h"
#include "walkcycle/loaders/LoadError.h"
#include "walkcycle/loaders/LoadLimits.h"
#include "walkcycle/model/Diagnostic.h"

namespace walkcycle {

// All faults, by name. DiagnosticCodes.inc is the catalogue of their texts.
enum class Code {
#define WC_CODE(number, name, severity, text, cause, ...) name,
#include "loaders/document/DiagnosticCodes.inc"
#undef WC_CODE
};

// A row of the catalogue.
struct CodeInfo {
    Code code;
    const char* id;    // "WC0207"
    const char* name;  // "WrongElement"
    Severity severity;
    const char* text;  // with placeholders, as is `cure`: see MessageTemplate.h
    const char* cause;
    const char* cure;
    // Menus to click for the cure in a modelling program; empty if it cannot be done there.
    const char* inBlender = "";
    const char* inMaya = "";
    const char* in3dsMax = "";
};

std::span<const CodeInfo> diagnosticCatalogue();
const CodeInfo& info(Code code);

// How many faults of one kind a loader looks up the exact line for, which takes a walk through the text. Later ones are
// only counted anyway.
inline constexpr int kMostLinesLookedFor = 3;

// Collects the messages of one load. A few of each code and element name are kept; more of them are only counted.
class Diagnostics {
public:
    using Arguments = std::initializer_list<std::string>;

    // After `mostMessages` kept messages, elements of all names are counted together.
    explicit Diagnostics(std::uint64_t mostMessages = LoadLimits{}.maxMessages)
        : mostMessages_(mostMessages) {}

    // `where` is the element that the message is about; `line`, if not 0, replaces the element's line. The last form is for
    // a message that is not about an element.
    void report(Code code, FileLocation where, Arguments arguments, int line = 0);
    void report(Severity severity, Code code, FileLocation where, Arguments arguments, int line = 0);
    void report(Code code, const std::string& file, int line, Arguments arguments);

    // Reports, then throws LoadError.
    [[noreturn]] void fail(Code code, FileLocation where, Arguments arguments, int line = 0);
    [[noreturn]] void fail(Code code, const std::string& file, int line, Arguments arguments);

    const std::vector<Diagnostic>& all() const { return all_; }
    std::vector<Diagnostic> take() { return std::move(all_); }

private:
    void add(Diagnostic diagnostic, std::string elementName);

    std::uint64_t mostMessages_;
    std::vector<Diagnostic> all_;
    // How often a message was reported, and where in all_ the last kept one is: by file, code and element name.
    std::map<std::tuple<std::string, std::string, std::string>, std::pair<int, std::size_t>> seen_;
    std::map<std::pair<std::string, std::string>, int> keptOfCode_;  // by file and code
};

}  // namespace walkcycle
