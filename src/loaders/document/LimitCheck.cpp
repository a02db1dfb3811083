#include "loaders/document/LimitCheck.h"

#include <cstddef>
#include <cstdint>

#include "io/TextScan.h"
#include "loaders/text/Markup.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

constexpr std::size_t kShortestElement = 4;  // <a/>
constexpr std::size_t kShortestNumber = 2;   // "1 "

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
    const std::size_t first = findMarkupBeyond(text, limits.maxElements);
    if (first == text.npos) return;
    const auto lines = static_cast<int>(countLineBreaks(text.substr(0, first)));
    requireWithin(limits, &LoadLimits::maxElements, limits.maxElements + 1, file, 1 + lines, diagnostics);
}

void requireModestElements(XmlNode root, std::size_t documentBytes, const LoadLimits& limits,
                           Diagnostics& diagnostics) {
    const bool deep = limits.maxNesting < limitInfo(&LoadLimits::maxNesting).most;
    if (!deep && documentBytes / kShortestNumber < limits.maxNumbers) return;
    const auto require = [&](XmlNode element, std::uint64_t level) {
        if (level > limits.maxNesting)
            diagnostics.fail(Code::TooDeep, element, {std::to_string(limits.maxNesting)});
        requireFewNumbers(element, limits, diagnostics);
    };
    require(root, 1);
    const XmlNode::Descendants all = root.descendants();
    for (auto it = all.begin(); it != all.end(); ++it)
        require(*it, static_cast<std::uint64_t>(it.depth()) + 1);
}

}  // namespace walkcycle
