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

// What is wrong, by name. The texts are in DiagnosticCodes.inc, the catalogue.
enum class Code {
#define WC_CODE(number, name, severity, text, cause, ...) name,
#include "loaders/document/DiagnosticCodes.inc"
#undef WC_CODE
};

struct CodeInfo {
    Code code;
    const char* id;    // "WC0207"
    const char* name;  // "WrongElement"
    Severity severity;
    const char* text;  // with placeholders, as is `cure`: see MessageTemplate.h
    const char* cause;
    const char* cure;
    // Where to click for it; empty where no author can do it there.
    const char* inBlender = "";
    const char* inMaya = "";
    const char* in3dsMax = "";
};

std::span<const CodeInfo> diagnosticCatalogue();
const CodeInfo& info(Code code);

// A loader that meets one fault again and again finds the exact line of the first few only: that takes a walk through
// the text, and the rest is but counted.
inline constexpr int kMostLinesLookedFor = 3;

// Collects what is said about one load. A kind of message is kept a few times per element name and after that only counted.
class Diagnostics {
public:
    using Arguments = std::initializer_list<std::string>;

    // After so many messages, all elements count as being of one name.
    explicit Diagnostics(std::uint64_t mostMessages = LoadLimits{}.maxMessages)
        : mostMessages_(mostMessages) {}

    // `where` is the element that the message is about; `line` overrides the element's own where it is known better.
    void report(Code code, FileLocation where, Arguments arguments, int line = 0);
    void report(Severity severity, Code code, FileLocation where, Arguments arguments, int line = 0);
    void report(Code code, const std::string& file, int line,
                Arguments arguments);  // where there is no element

    // Reports, then throws LoadError.
    [[noreturn]] void fail(Code code, FileLocation where, Arguments arguments, int line = 0);
    [[noreturn]] void fail(Code code, const std::string& file, int line, Arguments arguments);

    const std::vector<Diagnostic>& all() const { return all_; }
    std::vector<Diagnostic> take() { return std::move(all_); }

private:
    void add(Diagnostic diagnostic, std::string elementName);

    std::uint64_t mostMessages_;
    std::vector<Diagnostic> all_;
    std::map<std::tuple<std::string, std::string, std::string>, std::pair<int, std::size_t>>
        seen_;                                                       // file, code, element
    std::map<std::pair<std::string, std::string>, int> keptOfCode_;  // file, code
};

}  // namespace walkcycle
