#include "app/FormatNumber.h"

#include <array>
#include <charconv>

namespace walkcycle {

std::string formatNumber(double value) {
    std::array<char, 32> text{};
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
}

std::string formatFixed(double value, int digits) {
    std::array<char, 400> text{};
    const auto result =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
    return {text.data(), result.ptr};
}

std::string formatScientific(double value) {
    std::array<char, 32> text{};
    const auto result =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 1);
    return {text.data(), result.ptr};
}

}  // namespace walkcycle
