#include "loaders/LimitCheck.h"

#include <algorithm>

namespace walkcycle {
namespace {

constexpr std::size_t kShortestElement = 4;  // <a/>
constexpr std::size_t kShortestNumber = 2;   // "1 "

// Where the markup that begins at `at` ends. What is cut short ends with the text: the parser will say so.
std::size_t afterMarkup(std::string_view text, std::size_t at) {
    const auto after = [&](std::string_view end) {
        const std::size_t found = text.find(end, at);
        return found == std::string_view::npos ? text.size() : found + end.size();
    };
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) return after("-->");
    if (rest.starts_with("<![CDATA[")) return after("]]>");
    if (rest.starts_with("<?")) return after("?>");
    return at + 1;
}

std::uint64_t countWords(std::string_view text) {
    std::uint64_t words = 0;
    bool inWord = false;
    for (const char c : text) {
        const bool isSpace = static_cast<unsigned char>(c) <= ' ';
        words += !isSpace && !inWord;
        inWord = !isSpace;
    }
    return words;
}

void requireFewNumbers(XmlNode node, const LoadLimits& limits, Diagnostics& diagnostics) {
    std::string joined;
    const std::string_view text = node.rawText(joined);
    if (text.size() / kShortestNumber < limits.maxNumbers) return;
    requireWithin(limits, &LoadLimits::maxNumbers, countWords(text), node, diagnostics);
}

}  // namespace

LimitWords::LimitWords(std::uint64_t found, const LoadLimits& limits, std::uint64_t LoadLimits::*limit)
    : amount(std::to_string(found)),
      unit(limitInfo(limit).unit),
      name(limitInfo(limit).name),
      value(std::to_string(limits.*limit)) {}

std::string limitText(std::uint64_t amount, const LoadLimits& limits, std::uint64_t LoadLimits::*limit) {
    const LimitWords words(amount, limits, limit);
    return words.amount + " " + words.unit + " are over the limit " + words.name + "=" + words.value;
}

void requireWithin(const LoadLimits& limits, std::uint64_t LoadLimits::*limit, std::uint64_t amount,
                   const XmlNode& where, Diagnostics& diagnostics) {
    if (amount <= limits.*limit) return;
    const LimitWords words(amount, limits, limit);
    diagnostics.fail(Code::LimitExceeded, where, {words.amount, words.unit, words.name, words.value});
}

void requireWithin(const LoadLimits& limits, std::uint64_t LoadLimits::*limit, std::uint64_t amount,
                   const std::string& file, int line, Diagnostics& diagnostics) {
    if (amount <= limits.*limit) return;
    const LimitWords words(amount, limits, limit);
    diagnostics.fail(Code::LimitExceeded, file, line, {words.amount, words.unit, words.name, words.value});
}

ArchiveLimits archiveLimits(const LoadLimits& limits) {
    return {limits.maxArchiveBytes, limits.maxArchiveEntries, limits.maxArchiveRatio};
}

std::uint64_t LoadLimits::*limitOf(const ArchiveTooLarge& error) {
    return error.limit == &ArchiveLimits::maxTotalBytes ? &LoadLimits::maxArchiveBytes
           : error.limit == &ArchiveLimits::maxEntries  ? &LoadLimits::maxArchiveEntries
                                                        : &LoadLimits::maxArchiveRatio;
}

std::uint64_t LoadLimits::*limitOf(const ImageTooLarge& error) {
    return error.limit == &ImageLimits::maxPixels ? &LoadLimits::maxImagePixels
                                                  : &LoadLimits::maxImageDimension;
}

void requireFewElements(std::string_view text, const std::string& file, const LoadLimits& limits,
                        Diagnostics& diagnostics) {
    if (text.size() / kShortestElement <= limits.maxElements) return;
    std::uint64_t elements = 0;
    for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', afterMarkup(text, at))) {
        const std::string_view markup = text.substr(at, 5);
        if (markup.starts_with("</") || markup == "<?xml" || ++elements <= limits.maxElements) continue;
        const auto begin = text.begin();
        const auto lines = std::count(begin, begin + static_cast<std::ptrdiff_t>(at), '\n');
        requireWithin(limits, &LoadLimits::maxElements, elements, file, 1 + static_cast<int>(lines),
                      diagnostics);
    }
}

void requireModestElements(XmlNode root, std::size_t documentBytes, const LoadLimits& limits,
                           Diagnostics& diagnostics) {
    const bool deep = limits.maxNesting < limitInfo(&LoadLimits::maxNesting).most;
    if (!deep && documentBytes / kShortestNumber < limits.maxNumbers) return;
    std::uint64_t depth = 1;
    for (XmlNode node = root; node;) {
        if (depth > limits.maxNesting)
            diagnostics.fail(Code::TooDeep, node, {std::to_string(limits.maxNesting)});
        requireFewNumbers(node, limits, diagnostics);
        if (const XmlNode child = node.firstChild()) {
            node = child;
            ++depth;
            continue;
        }
        while (node && !node.nextSibling()) {
            node = node.parent();
            --depth;
        }
        if (node) node = node.nextSibling();
    }
}

}  // namespace walkcycle
