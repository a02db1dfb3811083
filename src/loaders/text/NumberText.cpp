#include "loaders/text/NumberText.h"

#include <cstddef>
#include <cstring>
#include <utility>

#include "io/TextScan.h"
#include "loaders/text/Markup.h"
#include "loaders/text/MarkupScanner.h"

namespace walkcycle {
namespace {

constexpr std::size_t kWorthCutting = 32;  // bytes; it is cheaper to leave shorter texts in place

bool endsName(char c) {
    return c == '>' || c == '/' || c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

int countLines(std::string_view text) {
    return static_cast<int>(countLineBreaks(text));
}

// Copies a document without the texts that it cuts out. The part before `copied_` is done.
class Cutter {
public:
    explicit Cutter(std::string_view document) : document_(document) {}

    std::optional<CutDocument> cut() {
        for (MarkupScanner markup(document_); markup.next();) {
            if (markup.end() == MarkupScanner::kNone || markup.attributes() > kMostAttributes)
                return std::nullopt;
            if (markup.kind() == MarkupScanner::Kind::StartTag)
                markup.moveTo(afterText(markup.begin(), markup.end()));
        }
        result_.remaining.append(document_.substr(copied_));
        return std::move(result_);
    }

private:
    bool startsWith(std::size_t at, std::string_view start) const {
        return document_.substr(at, start.size()) == start;
    }

    // Cuts out the text that follows the start tag [begin, end), if it can. Returns where that text ends, or `end`.
    std::size_t afterText(std::size_t begin, std::size_t end) {
        const std::string_view name = nameAt(begin + 1);
        if (!holdsNumberText(name)) return end;
        const bool isEmpty = document_[end - 2] == '/';
        result_.texts.push_back(isEmpty ? std::nullopt : textAt(begin, end, name));
        return end + (result_.texts.back() ? result_.texts.back()->text.size() : 0);
    }

    std::string_view nameAt(std::size_t at) const {
        std::size_t end = at;
        while (end < document_.size() && end - at < 16 && !endsName(document_[end])) ++end;
        return document_.substr(at, end - at);
    }

    std::optional<NumberText> textAt(std::size_t tag, std::size_t begin, std::string_view name) {
        const std::size_t end = document_.find('<', begin);
        if (end == std::string_view::npos || end - begin < kWorthCutting) return std::nullopt;
        const std::string_view text = document_.substr(begin, end - begin);
        const bool isClosed = startsWith(end, "</") && startsWith(end + 2, name);
        if (!isClosed || std::memchr(text.data(), '&', text.size())) return std::nullopt;
        result_.remaining.append(document_.substr(copied_, begin - copied_));
        result_.remaining.append(static_cast<std::size_t>(countLines(text)), '\n');
        copied_ = end;
        return NumberText{text, countLines(document_.substr(tag, begin - tag))};
    }

    std::string_view document_;
    std::size_t copied_ = 0;
    CutDocument result_;
};

}  // namespace

bool holdsNumberText(std::string_view elementName) {
    return elementName == "float_array" || elementName == "p" || elementName == "v" ||
           elementName == "vcount" || elementName == "Name_array" || elementName == "IDREF_array";
}

std::optional<CutDocument> cutNumberText(std::string_view document) {
    return Cutter(document).cut();
}

}  // namespace walkcycle
