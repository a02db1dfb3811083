#include "app/Numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "app/ExitCode.h"

namespace walkcycle {
namespace {

[[noreturn]] void fail(std::string_view text, const std::string& option, const std::string& expected) {
    throw UsageError(option + ": '" + std::string(text) + "' is not " + expected);
}

std::optional<double> number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(separator, start), text.size());
        parts.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return parts;
}

}  // namespace

double parseNumber(std::string_view text, const std::string& option) {
    const std::optional<double> value = number(text);
    if (!value) fail(text, option, "a number");
    return *value;
}

int parseInteger(std::string_view text, const std::string& option, int least, int most) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < least || value > most)
        fail(text, option, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return value;
}

std::uint64_t parseSize(std::string_view text, const std::string& option) {
    const std::string_view whole = text;
    int shift = 0;
    if (!text.empty()) {
        const char unit = text.back();
        shift = unit == 'k' || unit == 'K' ? 10 : unit == 'M' ? 20 : unit == 'G' ? 30 : 0;
        if (shift > 0) text.remove_suffix(1);
    }
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value > (UINT64_MAX >> shift))
        fail(whole, option, "a number such as 1500, 20k, 64M or 2G");
    return value << shift;
}

std::vector<double> parseNumbers(std::string_view text, const std::string& option) {
    std::vector<double> numbers;
    for (const std::string_view part : split(text, ',')) {
        const std::optional<double> value = number(part);
        if (!value) fail(text, option, "a number, or several with commas between them");
        numbers.push_back(*value);
    }
    return numbers;
}

glm::vec3 parseVector(std::string_view text, const std::string& option) {
    const std::vector<double> numbers = parseNumbers(text, option);
    if (numbers.size() != 3) fail(text, option, "three numbers X,Y,Z");
    return {numbers[0], numbers[1], numbers[2]};
}

std::pair<int, int> parsePair(std::string_view text, char separator, const std::string& option, int most) {
    const std::vector<std::string_view> parts = split(text, separator);
    if (parts.size() != 2)
        fail(text, option, std::string("two whole numbers with '") + separator + "' between them");
    return {parseInteger(parts[0], option, 1, most), parseInteger(parts[1], option, 1, most)};
}

glm::vec3 parseColor(std::string_view text, const std::string& option) {
    const std::string_view digits = text.starts_with('#') ? text.substr(1) : text;
    unsigned value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    const bool isShort = digits.size() == 3;
    if (error != std::errc() || end != digits.data() + digits.size() || (!isShort && digits.size() != 6))
        fail(text, option, "a colour such as #f0e8d8");
    const unsigned bits = isShort ? 4 : 8;
    const auto channel = [&](unsigned index) {
        return static_cast<float>((value >> (bits * (2 - index))) & ((1u << bits) - 1)) /
               static_cast<float>((1u << bits) - 1);
    };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace walkcycle
