#include "model/Diagnostic.h"

namespace walkcycle {
namespace {

const char* nameOf(Severity severity) {
    switch (severity) {
        case Severity::Info:
            return "info";
        case Severity::Warning:
            return "warning";
        case Severity::Error:
            return "error";
    }
    return "error";
}

}  // namespace

std::string toString(const Diagnostic& diagnostic) {
    std::string text = diagnostic.file;
    if (diagnostic.line > 0)
        text.append(text.empty() ? "line " : ":").append(std::to_string(diagnostic.line));
    if (!text.empty()) text += ": ";
    text += nameOf(diagnostic.severity);
    if (!diagnostic.code.empty()) text.append(" ").append(diagnostic.code);
    text.append(": ").append(diagnostic.message);
    if (!diagnostic.cure.empty()) text.append(" (").append(diagnostic.cure).append(")");
    if (diagnostic.repeats > 0)
        text.append(" [and ").append(std::to_string(diagnostic.repeats)).append(" more like it]");
    return text;
}

}  // namespace walkcycle
