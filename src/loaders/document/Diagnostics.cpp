#include "loaders/document/Diagnostics.h"

#include <cstddef>
#include <utility>

#include "loaders/document/MessageTemplate.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

#define WC_STRING_(text) #text
constexpr CodeInfo kCatalogue[] = {
#define WC_CODE(number, name, severity, text, cause, ...)                              \
    {Code::name, (number) < 1000 ? "WC0" WC_STRING_(number) : "WC" WC_STRING_(number), \
     #name,      Severity::severity,                                                   \
     text,       cause,                                                                \
     __VA_ARGS__},
#include "loaders/document/DiagnosticCodes.inc"
#undef WC_CODE
};
#undef WC_STRING_

// How many messages of one code about elements of one name are kept; more of them are only counted.
constexpr int kKeptPerKind = 3;
// How many messages of one code are kept in this way; after that, elements of all names are counted together.
constexpr int kKeptPerCode = 12;

std::string fillIn(const char* text, Diagnostics::Arguments arguments) {
    return replacePlaceholders(text, [&](std::size_t index, std::string_view) {
        return index < arguments.size() ? printable(arguments.begin()[index]) : std::string();
    });
}

// Moves everything out of `where` except the element's name.
Diagnostic make(Severity severity, Code code, FileLocation& where, int line,
                Diagnostics::Arguments arguments) {
    const CodeInfo& entry = info(code);
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.code = entry.id;
    diagnostic.file = std::move(where.file);
    diagnostic.line = where.line > 0 && line > 0 ? line : where.line;
    diagnostic.elementPath = std::move(where.elementPath);
    diagnostic.message = fillIn(entry.text, arguments);
    diagnostic.cure = fillIn(entry.cure, arguments);
    return diagnostic;
}

}  // namespace

std::span<const CodeInfo> diagnosticCatalogue() {
    return kCatalogue;
}
const CodeInfo& info(Code code) {
    return kCatalogue[static_cast<std::size_t>(code)];
}

void Diagnostics::add(Diagnostic diagnostic, std::string elementName) {
    int& kept = keptOfCode_[{diagnostic.file, diagnostic.code}];
    if (all_.size() >= mostMessages_ || kept >= kKeptPerCode) elementName.clear();
    auto& [count, lastIndex] = seen_[{diagnostic.file, diagnostic.code, elementName}];
    if (++count > kKeptPerKind) {
        ++all_[lastIndex].repeats;
        return;
    }
    ++kept;
    lastIndex = all_.size();
    all_.push_back(std::move(diagnostic));
}

void Diagnostics::report(Severity severity, Code code, FileLocation where, Arguments arguments, int line) {
    add(make(severity, code, where, line, arguments), std::move(where.elementName));
}

void Diagnostics::report(Code code, FileLocation where, Arguments arguments, int line) {
    report(info(code).severity, code, std::move(where), arguments, line);
}

void Diagnostics::report(Code code, const std::string& file, int line, Arguments arguments) {
    report(code, {file, line, {}, {}}, arguments);
}

void Diagnostics::fail(Code code, FileLocation where, Arguments arguments, int line) {
    all_.push_back(make(Severity::Error, code, where, line, arguments));  // kept in any case
    throw LoadError(all_);
}

void Diagnostics::fail(Code code, const std::string& file, int line, Arguments arguments) {
    fail(code, {file, line, {}, {}}, arguments);
}

}  // namespace walkcycle
