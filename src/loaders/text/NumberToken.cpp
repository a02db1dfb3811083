#include "loaders/text/NumberToken.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace walkcycle {
namespace {

// The exponent behind the 'e' of a number, clamped to 2^62 in size.
std::int64_t exponentOf(std::string_view digits) {
    if (digits.starts_with('+')) digits.remove_prefix(1);
    std::int64_t exponent = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    constexpr std::int64_t kHuge = std::int64_t{1} << 62;
    if (error == std::errc::result_out_of_range) return digits.starts_with('-') ? -kHuge : kHuge;
    return std::clamp(exponent, -kHuge, kHuge);
}

// For a number that from_chars reports as out of range: returns true, with 0 as the value, if it is too small; false, a
// fault, if it is too large. The power of ten of its first digit other than zero decides.
template <typename T>
bool roundsToZero(const char* first, const char* last, T& value) {
    const std::string_view token(first, static_cast<std::size_t>(last - first));
    const std::size_t e = token.find_first_of("eE");
    const std::string_view digits = token.substr(0, e);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const std::size_t digit = digits.find_first_of("123456789");
    const auto power = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(digit);
    value = T{};
    return power + (e == std::string_view::npos ? 0 : exponentOf(token.substr(e + 1))) < 0;
}

template <typename T>
bool parse(const char* first, const char* last, T& value) {
    if (last - first > 1 && *first == '+' && first[1] != '-')
        ++first;  // from_chars knows no plus sign; XML does
    const auto [end, error] = std::from_chars(first, last, value);
    if (end != last) return false;
    if constexpr (std::is_floating_point_v<T>) {
        if (error == std::errc::result_out_of_range) return roundsToZero(first, last, value);
        // A double that is too large for a float is out of range, too: the model is made of floats.
        return error == std::errc{} && std::abs(value) <= T{std::numeric_limits<float>::max()};
    }
    return error == std::errc{};
}

}  // namespace

bool parseToken(const char* first, const char* last, float& value) {
    return parse(first, last, value);
}
bool parseToken(const char* first, const char* last, double& value) {
    return parse(first, last, value);
}
bool parseToken(const char* first, const char* last, std::int32_t& value) {
    return parse(first, last, value);
}
bool parseToken(const char* first, const char* last, std::uint64_t& value) {
    return parse(first, last, value);
}

}  // namespace walkcycle
