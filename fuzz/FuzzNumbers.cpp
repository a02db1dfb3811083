// Any bytes as a list of numbers, against the C library's own parser.

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "Require.h"
#include "loaders/text/NumberParser.h"
#include "loaders/text/Words.h"

namespace {

using namespace walkcycle;

// strtod also takes "0x1", "inf" and "nan", which are no numbers here.
bool onlyDecimal(std::string_view token) {
    return token.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
}

void compare(std::string_view token) {
    double ours = 0.0;
    const bool isNumber = parseNumber(token, ours);
    if (!onlyDecimal(token)) {
        REQUIRE(!isNumber);
        return;
    }
    const std::string text(token);
    char* end = nullptr;
    const double theirs = std::strtod(text.c_str(), &end);
    constexpr double kMost = std::numeric_limits<float>::max();  // the model is made of floats
    const bool wanted = !text.empty() && *end == '\0' && std::abs(theirs) <= kMost;
    REQUIRE(isNumber == wanted);
    if (isNumber) REQUIRE(ours == theirs);
}

// A list is read on a shorter way than a word alone, where its words are plain: it must come to the same, bit by bit.
template <typename T>
void compareWithFromChars(std::string_view word, T value) {
    T theirs{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), theirs);
    if (end != word.data() + word.size() || error != std::errc{}) return;
    const bool isHeld = std::abs(static_cast<double>(theirs)) <= std::numeric_limits<float>::max();
    if (std::is_floating_point_v<T> && !isHeld) return;
    REQUIRE(std::memcmp(&theirs, &value, sizeof value) == 0);
}

template <typename T>
std::size_t parsed(std::string_view text) {
    std::vector<T> values;
    std::vector<NumberFault> faults;
    parseNumbers(text, values, faults);
    REQUIRE(faults.size() <= kMaxFaults);
    for (const NumberFault& fault : faults) {
        REQUIRE(fault.index < values.size());
        REQUIRE(fault.offset + fault.token.size() <= text.size());
        REQUIRE(text.substr(fault.offset, fault.token.size()) == fault.token);
        REQUIRE(values[fault.index] == T{});
    }
    if constexpr (!std::is_integral_v<T>)
        for (const T value : values) REQUIRE(std::isfinite(value));
    const std::vector<std::string_view> words = splitWords(text);
    REQUIRE(words.size() == values.size());
    for (std::size_t i = 0; i < words.size(); ++i) compareWithFromChars(words[i], values[i]);
    return values.size();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // A copy without a final zero: reading past the end is an error that the sanitizer sees.
    const std::vector<char> bytes(data, data + size);
    const std::string_view text(bytes.data(), bytes.size());
    const std::vector<std::string_view> words = splitWords(text);
    REQUIRE(parsed<float>(text) == words.size());
    REQUIRE(parsed<double>(text) == words.size());
    REQUIRE(parsed<std::int32_t>(text) == words.size());
    for (const std::string_view word : words)
        if (std::memchr(word.data(), '\0', word.size()) == nullptr) compare(word);
    std::int32_t integer = 0;
    std::uint64_t count = 0;
    parseNumber(text, integer);
    parseUnsigned(text, count);
    return 0;
}
