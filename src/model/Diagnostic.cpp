#include "walkcycle/model/Diagnostic.h"

#include <cstddef>
#include <string_view>

namespace walkcycle {
namespace {

constexpr std::size_t kLongPath = 120;

// The element path for a one-line message, without the root element. Of a long path only the end is kept,
// from the last element with an id on (or from earlier), which is enough to find the place.
std::string placeIn(std::string_view path) {
    const std::size_t root = path.find('/');
    if (root == std::string_view::npos) return {};  // the document as a whole
    path.remove_prefix(root + 1);
    if (path.size() <= kLongPath) return std::string(path);
    std::size_t start = path.find('/', path.size() - kLongPath);
    const std::size_t id = path.rfind("[id=");
    if (id != std::string_view::npos && id < start) start = path.rfind('/', id);
    return start == std::string_view::npos ? std::string(path) : "..." + std::string(path.substr(start));
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
    if (const std::string place = placeIn(diagnostic.elementPath); !place.empty())
        text.append(", in ").append(place);
    if (!diagnostic.cure.empty()) text.append(" (").append(diagnostic.cure).append(")");
    if (diagnostic.repeats > 0)
        text.append(" [and ").append(std::to_string(diagnostic.repeats)).append(" more like it]");
    return text;
}

}  // namespace walkcycle
