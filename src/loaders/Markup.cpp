#include "loaders/Markup.h"

#include "io/TextScan.h"

namespace walkcycle {
namespace {

constexpr std::size_t kNone = std::string_view::npos;

bool startsWith(std::string_view document, std::size_t at, std::string_view start) {
    return document.substr(at, start.size()) == start;
}

std::size_t after(std::string_view document, std::size_t at, std::string_view end) {
    const std::size_t found = document.find(end, at);
    return found == kNone ? found : found + end.size();
}

// Just behind a tag's '>', which may stand in an attribute's quotes as well. Counts the quoted values.
std::size_t afterTag(std::string_view document, std::size_t at, std::size_t& attributes) {
    attributes = 0;
    while (at < document.size()) {
        const char c = document[at++];
        if (c == '>') return at;
        if (c != '"' && c != '\'') continue;
        ++attributes;
        at = document.find(c, at);
        if (at == kNone) return at;
        ++at;
    }
    return kNone;
}

// Just behind the markup that begins at `at`; kNone where it does not end, or is a DOCTYPE, which may hold anything.
std::size_t afterMarkup(std::string_view document, std::size_t at) {
    if (startsWith(document, at, "<!--")) return after(document, at + 4, "-->");
    if (startsWith(document, at, "<![CDATA[")) return after(document, at, "]]>");
    if (startsWith(document, at, "<?")) return after(document, at, "?>");
    std::size_t attributes = 0;
    return startsWith(document, at, "<!") ? kNone : afterTag(document, at, attributes);
}

}  // namespace

std::optional<std::string> withoutInstructions(std::string_view document) {
    const std::size_t declaration = document.find('<');
    if (declaration == kNone || document.find("<?", declaration + 1) == kNone) return std::nullopt;
    std::string kept;
    std::size_t copied = 0;
    for (std::size_t at = declaration, end = 0; at != kNone; at = document.find('<', end)) {
        end = afterMarkup(document, at);
        if (end == kNone) break;
        if (at == declaration || !startsWith(document, at, "<?")) continue;
        kept.append(document, copied, at - copied);
        kept.append(countLineBreaks(document.substr(at, end - at)), '\n');
        copied = end;
    }
    if (copied == 0) return std::nullopt;
    kept.append(document, copied);
    return kept;
}

std::size_t findCrowdedTag(std::string_view document, std::size_t mostAttributes) {
    const std::size_t shortest = 5 * mostAttributes;  // ' a=""', so many times
    for (std::size_t at = document.find('<'); at != kNone;) {
        const std::size_t next = document.find('<', at + 1);
        const std::size_t length = (next == kNone ? document.size() : next) - at;
        std::size_t attributes = 0;
        if (length > shortest) afterTag(document.substr(0, at + length), at, attributes);
        if (attributes > mostAttributes) return at;
        at = next;
    }
    return kNone;
}

}  // namespace walkcycle
