#include "loaders/Diagnostics.h"

#include <cstdio>

#include "loaders/XmlNode.h"

namespace walkcycle {
namespace {

#define WC_STRING_(text) #text
constexpr CodeInfo kCatalogue[] = {
#define WC_CODE(number, name, severity, text, cause, cure) \
    {Code::name, "WC0" WC_STRING_(number), #name, Severity::severity, text, cause, cure},
#include "loaders/DiagnosticCodes.inc"
#undef WC_CODE
};
#undef WC_STRING_

// How many of one kind, about elements of one name, are kept before the rest is only counted.
constexpr int kKeptPerKind = 3;
constexpr std::size_t kLongestArgument = 200;

// The argument as it may stand in a one-line message: no control characters, not endless.
std::string printable(const std::string& argument) {
    std::string text = argument.substr(0, kLongestArgument);
    if (argument.size() > kLongestArgument) {
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
        if (!text.empty() && static_cast<unsigned char>(text.back()) >= 0xC0) text.pop_back();
        text += "...";
    }
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == 0x7F) c = ' ';
    return text;
}

std::string fillIn(const char* text, Diagnostics::Arguments arguments) {
    std::string filled;
    for (const char* c = text; *c; ++c) {
        if (c[0] == '{' && c[1] >= '0' && c[1] <= '9' && c[2] == '}') {
            const auto index = static_cast<std::size_t>(c[1] - '0');
            if (index < arguments.size()) filled += printable(arguments.begin()[index]);
            c += 2;
        } else {
            filled += *c;
        }
    }
    return filled;
}

Diagnostic make(Severity severity, Code code, Diagnostics::Arguments arguments) {
    const CodeInfo& entry = info(code);
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.code = entry.id;
    diagnostic.message = fillIn(entry.text, arguments);
    diagnostic.cure = entry.cure;
    return diagnostic;
}

}  // namespace

std::span<const CodeInfo> diagnosticCatalogue() { return kCatalogue; }
const CodeInfo& info(Code code) { return kCatalogue[static_cast<std::size_t>(code)]; }

LoadError::LoadError(std::vector<Diagnostic> all)
    : std::runtime_error(all.empty() ? "nothing could be loaded" : toString(all.back())), diagnostics(std::move(all)) {}

void Diagnostics::add(Diagnostic diagnostic, const std::string& elementName) {
    auto& [count, lastIndex] = seen_[{diagnostic.file, diagnostic.code, elementName}];
    if (++count > kKeptPerKind) {
        ++all_[lastIndex].repeats;
        return;
    }
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
    fail(code, where ? where.file() : std::string(), line > 0 ? line : where.line(), arguments);
}

void Diagnostics::fail(Code code, const std::string& file, int line, Arguments arguments) {
    Diagnostic diagnostic = make(Severity::Error, code, arguments);
    diagnostic.file = file;
    diagnostic.line = line;
    all_.push_back(std::move(diagnostic));  // never only counted: it is the reason
    throw LoadError(all_);
}

}  // namespace walkcycle
