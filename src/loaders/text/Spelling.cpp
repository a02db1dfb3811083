#include "loaders/text/Spelling.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

constexpr std::size_t kLongestWord = 40;  // bytes; no word of the format is longer

char lowerCase(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// The Damerau-Levenshtein distance: how many letters must be added, left out, changed or swapped with their neighbour.
std::size_t slipsBetween(std::string_view a, std::string_view b) {
    using Row = std::array<std::size_t, kLongestWord + 1>;
    Row twoBefore{}, before{}, row{};
    for (std::size_t j = 0; j <= b.size(); ++j) before[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lowerCase(a[i - 1]) == lowerCase(b[j - 1]);
            row[j] = std::min({before[j] + 1, row[j - 1] + 1, before[j - 1] + (same ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && lowerCase(a[i - 1]) == lowerCase(b[j - 2]) &&
                                 lowerCase(a[i - 2]) == lowerCase(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], twoBefore[j - 2] + 1);
        }
        twoBefore = before;
        before = row;
    }
    return before[b.size()];
}

}  // namespace

std::string_view nearest(std::string_view word, std::string_view known) {
    if (word.empty() || word.size() > kLongestWord) return {};
    std::string_view best;
    std::size_t fewest = std::min<std::size_t>(2, word.size() / 3) + 1;  // this many are too many
    for (const std::string_view candidate : splitWords(known)) {
        if (candidate.size() > kLongestWord) continue;
        const std::size_t slips = slipsBetween(word, candidate);
        if (slips < fewest) best = candidate, fewest = slips;
    }
    return best;
}

std::string didYouMean(std::string_view word, std::string_view known) {
    const std::string_view meant = nearest(word, known);
    return meant.empty() ? std::string() : "; perhaps '" + std::string(meant) + "' is meant";
}

std::string inAnotherCase(const std::vector<std::string>& names, const std::string& name) {
    const auto same = [&](const std::string& other) {
        return std::equal(other.begin(), other.end(), name.begin(), name.end(),
                          [](char a, char b) { return lowerCase(a) == lowerCase(b); });
    };
    const auto found = std::find_if(names.begin(), names.end(), same);
    return found == names.end() ? std::string() : *found;
}

}  // namespace walkcycle
