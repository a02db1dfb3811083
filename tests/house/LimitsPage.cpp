#include "LimitsPage.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "walkcycle/loaders/LoadLimits.h"

namespace walkcycle::house {
namespace {

// As one would type it: 1G, 64M; else with a comma before each three digits.
std::string amountText(std::uint64_t amount) {
    for (const auto& [shift, unit] : {std::pair(30, "G"), std::pair(20, "M")})
        if (amount > 0 && amount % (std::uint64_t{1} << shift) == 0)
            return std::to_string(amount >> shift) + unit;
    std::string digits = std::to_string(amount);
    for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
    return digits;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
}

}  // namespace

std::string limitsPage() {
    std::string page =
        "# What a load may cost\n\n"
        "Files from strangers must not cost more than they should: a few bytes can ask for gigabytes. Honest "
        "files of "
        "150 MB load under these limits, in time and memory that grow with their size and no faster. What "
        "passes a "
        "limit is refused with `WC0801` (pictures are left out with `WC0803`); the message names the limit, "
        "its value "
        "and the element. Every verb that reads a document takes `--limit NAME=VALUE`, as often as needed, "
        "with k, M "
        "and G of 1024:\n\n"
        "```\nwalkcycle check huge.dae --limit file-bytes=4G --limit elements=100000000\n```\n\n"
        "In the library they are `LoadOptions::limits`. No memory is ever taken for a count that a file only "
        "claims.\n\n"
        "This page is made from `include/walkcycle/loaders/LoadLimits.h`; do not edit it. "
        "`tests/loaders/document/LimitsTest.cpp` "
        "tries each "
        "one below, at, and one over its limit.\n\n"
        "| limit | default | of | why |\n|---|---|---|---|\n";
    for (const LimitInfo& limit : kLimits) {
        page += "| `" + std::string(limit.name) + "` | " + amountText(LoadLimits{}.*limit.value);
        if (limit.most == LoadLimits{}.*limit.value)
            page += " (at most)";
        else if (limit.most != UINT64_MAX)
            page += " (at most " + amountText(limit.most) + ")";
        page += " | " + escaped(limit.unit) + " | " + escaped(limit.why) + " |\n";
    }
    return page;
}

}  // namespace walkcycle::house
