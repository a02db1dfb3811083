#include "loaders/NumberParser.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace walkcycle {
namespace {

// Every control character counts as white space: exporters have written all of them.
bool isSpace(char c) {
    return static_cast<unsigned char>(c) <= ' ';
}

// A number too small to be told from zero is zero; one too large is a fault. from_chars reports both alike.
template <typename T>
bool roundsToZero(const char* first, const char* last, T& value) {
    const std::string_view token(first, static_cast<std::size_t>(last - first));
    const std::size_t exponent = token.find_first_of("eE");
    const bool smallExponent =
        exponent != std::string_view::npos && exponent + 1 < token.size() && token[exponent + 1] == '-';
    const bool fraction =
        exponent == std::string_view::npos && token.find_first_of("123456789") > token.find('.');
    value = T{};
    return smallExponent || fraction;
}

template <typename T>
bool parseToken(const char* first, const char* last, T& value) {
    if (last - first > 1 && *first == '+' && first[1] != '-')
        ++first;  // from_chars knows no plus sign; XML does
    const auto [end, error] = std::from_chars(first, last, value);
    if (end != last) return false;
    if constexpr (std::is_floating_point_v<T>) {
        if (error == std::errc::result_out_of_range) return roundsToZero(first, last, value);
        // A double that no float can hold is out of range as well: the model is made of floats.
        return error == std::errc{} && std::abs(value) <= T{std::numeric_limits<float>::max()};
    }
    return error == std::errc{};
}

template <typename T>
void parseList(std::string_view text, std::vector<T>& values, std::vector<NumberFault>& faults) {
    const char* at = text.data();
    const char* const end = at + text.size();
    const std::size_t before = values.size();
    for (;;) {
        while (at != end && isSpace(*at)) ++at;
        if (at == end) return;
        const char* const token = at;
        while (at != end && !isSpace(*at)) ++at;
        T value{};
        if (!parseToken(token, at, value)) {
            value = T{};
            if (faults.size() < kMaxFaults)
                faults.push_back({values.size() - before,
                                  static_cast<std::size_t>(token - text.data()),
                                  {token, static_cast<std::size_t>(at - token)}});
        }
        values.push_back(value);
    }
}

constexpr int kTokensAround = 3;
constexpr std::size_t kLongestToken = 20;

std::string shortened(std::string_view token) {
    return token.size() > kLongestToken ? std::string(token.substr(0, kLongestToken)) + "..."
                                        : std::string(token);
}

// The last or first token of a text; empty where there is none.
std::string_view lastToken(std::string_view text) {
    text = trim(text);
    std::size_t start = text.size();
    while (start > 0 && !isSpace(text[start - 1])) --start;
    return text.substr(start);
}
std::string_view firstToken(std::string_view text) {
    text = trim(text);
    std::size_t end = 0;
    while (end < text.size() && !isSpace(text[end])) ++end;
    return text.substr(0, end);
}

template <typename T>
bool parseOne(std::string_view text, T& value) {
    text = trim(text);
    return !text.empty() && parseToken(text.data(), text.data() + text.size(), value);
}

}  // namespace

void parseNumbers(std::string_view text, std::vector<float>& values, std::vector<NumberFault>& faults) {
    parseList(text, values, faults);
}
void parseNumbers(std::string_view text, std::vector<double>& values, std::vector<NumberFault>& faults) {
    parseList(text, values, faults);
}
void parseNumbers(std::string_view text, std::vector<std::int32_t>& values,
                  std::vector<NumberFault>& faults) {
    parseList(text, values, faults);
}

std::string surroundings(std::string_view text, const NumberFault& fault) {
    std::string around = shortened(fault.token);
    std::string_view before = text.substr(0, fault.offset);
    std::string_view after = text.substr(fault.offset + fault.token.size());
    if (trim(before).empty() && trim(after).empty()) return {};
    for (int i = 0; i < kTokensAround; ++i) {
        if (const std::string_view token = lastToken(before); !token.empty()) {
            around = shortened(token) + " " + around;
            before = before.substr(0, static_cast<std::size_t>(token.data() - before.data()));
        }
        if (const std::string_view token = firstToken(after); !token.empty()) {
            around += " " + shortened(token);
            after.remove_prefix(static_cast<std::size_t>(token.data() - after.data()) + token.size());
        }
    }
    if (!trim(before).empty()) around = "... " + around;
    if (!trim(after).empty()) around += " ...";
    return around;
}

bool parseNumber(std::string_view text, double& value) {
    return parseOne(text, value);
}
bool parseNumber(std::string_view text, std::int32_t& value) {
    return parseOne(text, value);
}
bool parseUnsigned(std::string_view text, std::uint64_t& value) {
    return parseOne(text, value);
}

std::string_view trim(std::string_view text) {
    while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
    while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
    return text;
}

std::vector<std::string_view> splitWords(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at < text.size();) {
        if (isSpace(text[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && !isSpace(text[end])) ++end;
        words.push_back(text.substr(at, end - at));
        at = end;
    }
    return words;
}

}  // namespace walkcycle
