#include "loaders/text/Markup.h"

#include "io/TextScan.h"
#include "loaders/text/MarkupScanner.h"

namespace walkcycle {

std::optional<std::string> withoutInstructions(std::string_view document) {
    using Kind = MarkupScanner::Kind;
    const std::size_t declaration = document.find('<');
    if (declaration == document.npos || document.find("<?", declaration + 1) == document.npos)
        return std::nullopt;
    std::string kept;
    std::size_t copied = 0;
    for (MarkupScanner markup(document); markup.next() && markup.end() != MarkupScanner::kNone;) {
        if (markup.begin() == declaration || markup.kind() != Kind::Instruction) continue;
        kept.append(document, copied, markup.begin() - copied);
        kept.append(countLineBreaks(document.substr(markup.begin(), markup.end() - markup.begin())), '\n');
        copied = markup.end();
    }
    if (copied == 0) return std::nullopt;
    kept.append(document, copied);
    return kept;
}

std::size_t findCrowdedTag(std::string_view document, std::size_t mostAttributes) {
    for (MarkupScanner markup(document); markup.next();) {
        if (markup.attributes() > mostAttributes) return markup.begin();
        if (markup.kind() == MarkupScanner::Kind::Declaration) markup.moveTo(markup.begin() + 1);
    }
    return MarkupScanner::kNone;
}

std::size_t findMarkupBeyond(std::string_view document, std::uint64_t most) {
    using Kind = MarkupScanner::Kind;
    std::uint64_t found = 0;
    for (MarkupScanner markup(document); markup.next();) {
        const bool counts =
            markup.kind() != Kind::EndTag && !document.substr(markup.begin()).starts_with("<?xml");
        if (counts && ++found > most) return markup.begin();
        if (markup.kind() == Kind::Declaration) markup.moveTo(markup.begin() + 1);
    }
    return MarkupScanner::kNone;
}

}  // namespace walkcycle
