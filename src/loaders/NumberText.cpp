#include "loaders/NumberText.h"

#include <cstring>

#include "io/TextScan.h"

namespace walkcycle {
namespace {

constexpr std::size_t kWorthCutting = 32;  // shorter texts cost less in place

bool endsName(char c) {
    return c == '>' || c == '/' || c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

int countLines(std::string_view text) {
    return static_cast<int>(countLineBreaks(text));
}

// Walks the markup; everything between `copied_` and the cut is carried over.
class Cutter {
public:
    explicit Cutter(std::string_view document) : document_(document) {}

    std::optional<CutDocument> cut() {
        for (std::size_t at = document_.find('<'); at != std::string_view::npos;
             at = document_.find('<', at)) {
            at = startsWith(at, "<!") || startsWith(at, "<?") ? afterSpecial(at) : afterTag(at);
            if (at == std::string_view::npos) return std::nullopt;
        }
        result_.remaining.append(document_.substr(copied_));
        return std::move(result_);
    }

private:
    bool startsWith(std::size_t at, std::string_view start) const {
        return document_.substr(at, start.size()) == start;
    }

    std::size_t after(std::size_t at, std::string_view end) const {
        const std::size_t found = document_.find(end, at);
        return found == std::string_view::npos ? found : found + end.size();
    }

    std::size_t afterSpecial(std::size_t at) const {
        if (startsWith(at, "<!--")) return after(at + 4, "-->");
        if (startsWith(at, "<![CDATA[")) return after(at, "]]>");
        return startsWith(at, "<?") ? after(at, "?>") : std::string_view::npos;
    }

    // Just behind the tag's '>', which may stand in an attribute's quotes as well.
    std::size_t endOfTag(std::size_t at) const {
        while (at < document_.size()) {
            const char c = document_[at++];
            if (c == '>') return at;
            if (c != '"' && c != '\'') continue;
            at = document_.find(c, at);
            if (at == std::string_view::npos) return at;
            ++at;
        }
        return std::string_view::npos;
    }

    std::size_t afterTag(std::size_t at) {
        const std::size_t end = endOfTag(at);
        if (end == std::string_view::npos || startsWith(at, "</")) return end;
        const std::string_view name = nameAt(at + 1);
        if (!holdsNumberText(name)) return end;
        const bool isEmpty = document_[end - 2] == '/';
        result_.texts.push_back(isEmpty ? std::nullopt : textAt(at, end, name));
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
