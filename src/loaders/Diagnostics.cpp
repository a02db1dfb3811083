#include "loaders/Diagnostics.h"

#include <algorithm>

#include "loaders/MessageTemplate.h"
#include "loaders/XmlNode.h"

namespace walkcycle {
namespace {

#define WC_STRING_(text) #text
constexpr CodeInfo kCatalogue[] = {
#define WC_CODE(number, name, severity, text, cause, ...)                              \
    {Code::name, (number) < 1000 ? "WC0" WC_STRING_(number) : "WC" WC_STRING_(number), \
     #name,      Severity::severity,                                                   \
     text,       cause,                                                                \
     __VA_ARGS__},
#include "loaders/DiagnosticCodes.inc"
#undef WC_CODE
};
#undef WC_STRING_

// How many of one kind, about elements of one name, are kept before the rest is only counted.
constexpr int kKeptPerKind = 3;
// So many of one code, whatever the elements are called, are a picture of the whole.
constexpr int kKeptPerCode = 12;
constexpr std::size_t kLongestArgument = 200;

bool continuesCharacter(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

std::string fillIn(const char* text, Diagnostics::Arguments arguments) {
    return replacePlaceholders(text, [&](std::size_t index, std::string_view) {
        return index < arguments.size() ? printable(arguments.begin()[index]) : std::string();
    });
}

Diagnostic make(Severity severity, Code code, Diagnostics::Arguments arguments) {
    const CodeInfo& entry = info(code);
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.code = entry.id;
    diagnostic.message = fillIn(entry.text, arguments);
    diagnostic.cure = fillIn(entry.cure, arguments);
    return diagnostic;
}

}  // namespace

std::string printable(std::string_view text) {
    std::size_t length = std::min(text.size(), kLongestArgument);
    while (length > 0 && length < text.size() && continuesCharacter(text[length])) --length;
    std::string shown(text.substr(0, length));
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < ' ' || c == 0x7F) c = ' ';
    return length < text.size() ? shown + "..." : shown;
}

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

void Diagnostics::report(Severity severity, Code code, const XmlNode& where, Arguments arguments, int line) {
    Diagnostic diagnostic = make(severity, code, arguments);
    if (where) {
        diagnostic.file = where.file();
        diagnostic.line = line > 0 ? line : where.line();
        diagnostic.elementPath = where.path();
    }
    add(std::move(diagnostic), where ? std::string(where.name()) : std::string());
}

void Diagnostics::report(Code code, const XmlNode& where, Arguments arguments, int line) {
    report(info(code).severity, code, where, arguments, line);
}

void Diagnostics::report(Code code, const std::string& file, int line, Arguments arguments) {
    Diagnostic diagnostic = make(info(code).severity, code, arguments);
    diagnostic.file = file;
    diagnostic.line = line;
    add(std::move(diagnostic), {});
}

void Diagnostics::fail(Code code, const XmlNode& where, Arguments arguments, int line) {
    Diagnostic diagnostic = make(Severity::Error, code, arguments);
    diagnostic.file = where.file();
    diagnostic.line = line > 0 ? line : where.line();
    diagnostic.elementPath = where.path();
    giveUp(std::move(diagnostic));
}

void Diagnostics::fail(Code code, const std::string& file, int line, Arguments arguments) {
    Diagnostic diagnostic = make(Severity::Error, code, arguments);
    diagnostic.file = file;
    diagnostic.line = line;
    giveUp(std::move(diagnostic));
}

void Diagnostics::giveUp(Diagnostic reason) {
    all_.push_back(std::move(reason));  // never only counted
    throw LoadError(all_);
}

}  // namespace walkcycle
