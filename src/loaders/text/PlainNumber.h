#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "loaders/text/Words.h"

namespace walkcycle {

// readPlain() parses numbers as exporters write them, in one pass over their characters. It leaves unusual ones (very many
// digits, a large exponent, a plus sign, no number at all) to the caller. `at` is the first character of a word. White
// space must follow the word, and at least seven more characters after that, since eight are loaded at once. It returns
// where the word ends, or null if the word is unusual; so do the functions that it calls.

// Powers of ten. (As constants within a function they would be copied to the stack for each number.)
inline constexpr std::array<std::uint32_t, 9> kWholePowers{1,      10,      100,      1000,     10000,
                                                           100000, 1000000, 10000000, 100000000};
inline constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

inline bool isDigit(char c) {
    return static_cast<unsigned char>(c - '0') < 10;
}

inline constexpr bool kFirstByteIsLowest = std::endian::native == std::endian::little;

// Loads eight characters; a byte that holds a digit becomes the digit's value.
inline std::uint64_t eightDigits(const char* at) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, at, 8);
    return bytes ^ 0x3030303030303030u;
}

// The number that eight digits make; the first digit is in the lowest byte. Joins neighbours into pairs, pairs into fours,
// and these into eight.
inline std::uint32_t joinDigits(std::uint64_t bytes) {
    bytes = bytes * 10 + (bytes >> 8);
    bytes = (bytes & 0x000000FF000000FFu) * 0x000F424000000064u +
            ((bytes >> 16) & 0x000000FF000000FFu) * 0x0000271000000001u;
    return static_cast<std::uint32_t>(bytes >> 32);
}

// Parses the digits at the start of eight characters, and returns how many there are. On a little-endian machine it
// handles all at once: the characters from the first other one on are shifted out.
inline unsigned readUpToEightDigits(const char* at, std::uint32_t& number) {
    if constexpr (kFirstByteIsLowest) {
        const std::uint64_t bytes = eightDigits(at);
        const std::uint64_t others = ((bytes + 0x7676767676767676u) | bytes) & 0x8080808080808080u;
        const unsigned bits = others == 0 ? 64u : static_cast<unsigned>(std::countr_zero(others)) & ~7u;
        if (bits == 0) return number = 0;
        number = joinDigits(bytes << (64 - bits));
        return bits / 8;
    } else {
        unsigned count = 0;
        for (number = 0; count < 8 && isDigit(at[count]); ++count)
            number = number * 10 + static_cast<std::uint32_t>(at[count] - '0');
        return count;
    }
}

inline const char* readPlain(const char* at, std::int32_t& value) {
    const bool negative = *at == '-';
    at += negative;
    const char* const first = at;
    std::uint32_t number = static_cast<unsigned char>(*at - '0');
    if (number >= 10) return nullptr;
    for (++at; isDigit(*at); ++at) number = number * 10 + static_cast<std::uint32_t>(*at - '0');
    if (at - first > 9 || !isWhiteSpace(*at)) return nullptr;
    value = negative ? -static_cast<std::int32_t>(number) : static_cast<std::int32_t>(number);
    return at;
}

// Digits, with or without a point: the whole number that they make, and how many of them are behind the point.
struct PlainDigits {
    std::uint64_t number = 0;
    unsigned behindPoint = 0;
    bool isLong = false;  // false: at most eight digits
};

// Returns null if the first character is no digit, or if the number might not fit into 64 bits.
inline const char* readDigits(const char* at, PlainDigits& digits) {
    constexpr std::ptrdiff_t kLongest = 19;  // eighteen digits and the point
    const char* const first = at;
    const auto digit = static_cast<unsigned char>(*at - '0');
    if (digit >= 10) return nullptr;
    digits.number = digit;
    for (++at; isDigit(*at); ++at, digits.isLong = true)
        digits.number = digits.number * 10 + static_cast<std::uint64_t>(*at - '0');
    if (*at == '.') {
        ++at;
        std::uint32_t some = 0;
        unsigned count = readUpToEightDigits(at, some);
        digits.number = digits.number * kWholePowers[count] + some;
        for (digits.behindPoint = count; count == 8; digits.behindPoint += count) {
            digits.isLong = true;
            count = readUpToEightDigits(at + digits.behindPoint, some);
            digits.number = digits.number * kWholePowers[count] + some;
        }
        at += digits.behindPoint;
    }
    return digits.isLong && at - first > kLongest ? nullptr : at;
}

// Parses the exponent behind an 'e'; returns null unless it is one to four digits.
inline const char* readExponent(const char* at, std::ptrdiff_t& exponent) {
    const bool negative = *at == '-';
    if (negative || *at == '+') ++at;
    std::uint32_t number = 0;
    const unsigned count = readUpToEightDigits(at, number);
    at += count;
    exponent = negative ? -static_cast<std::ptrdiff_t>(number) : static_cast<std::ptrdiff_t>(number);
    return count == 0 || count > 4 || !isWhiteSpace(*at) ? nullptr : at;
}

// number / 10^power. A number of at most 53 bits and the power are both exact as doubles, so that the only rounding is the
// division's, and the result is the nearest double (W. Clinger, "How to Read Floating Point Numbers Accurately", 1990).
// With more bits, it may be two units in the last place off.
inline double overPower(std::uint64_t number, std::ptrdiff_t power) {
    return static_cast<double>(static_cast<std::int64_t>(number)) / kPowers[static_cast<std::size_t>(power)];
}

inline double withSign(double value, std::uint64_t isNegative) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) | isNegative << 63);
}

// The same for a number with an exponent. Returns false if the power is too large, or the number too large for a float.
inline bool withExponent(const PlainDigits& digits, std::ptrdiff_t exponent, double& value) {
    const std::ptrdiff_t power =
        digits.number == 0 ? 0 : exponent - static_cast<std::ptrdiff_t>(digits.behindPoint);
    constexpr auto kMostPower = static_cast<std::ptrdiff_t>(kPowers.size()) - 1;
    if (power < -kMostPower || power > kMostPower) return false;
    value = power < 0 ? overPower(digits.number, -power)
                      : overPower(digits.number, 0) * kPowers[static_cast<std::size_t>(power)];
    return value < std::numeric_limits<float>::max();
}

inline constexpr std::uint64_t kExactInDouble = std::uint64_t{1} << 53;

// Parses a number. Long digits that make more than `most` are unusual; above 2^53 the result is not quite the nearest double.
inline const char* readNearby(const char* at, std::uint64_t most, double& value) {
    const std::uint64_t sign = static_cast<std::uint64_t>(*at == '-');
    PlainDigits digits;
    at = readDigits(at + sign, digits);
    if (!at || (digits.isLong && digits.number > most)) return nullptr;
    if (isWhiteSpace(*at)) {
        value = overPower(digits.number, digits.behindPoint);
    } else {
        if (*at != 'e' && *at != 'E') return nullptr;
        std::ptrdiff_t exponent = 0;
        at = readExponent(at + 1, exponent);
        if (!at || !withExponent(digits, exponent, value)) return nullptr;
    }
    value = withSign(value, sign);
    return at;
}

inline const char* readPlain(const char* at, double& value) {
    return readNearby(at, kExactInDouble, value);
}

// Rounds a double that is within a few units in the last place of a number to the float nearest to that number. Returns
// false if the double is about halfway between two floats: the number might be nearer to the other one. (Except zero, no
// double from readNearby() is too small or too large for a normal float.)
inline bool roundAgain(double nearby, float& value) {
    constexpr std::uint64_t kBitsBelow = (1u << 29) - 1, kHalf = 1u << 28, kSlack = 4;
    value = static_cast<float>(nearby);
    return (std::bit_cast<std::uint64_t>(nearby) & kBitsBelow) - (kHalf - kSlack) > 2 * kSlack;
}

inline const char* readPlain(const char* at, float& value) {
    double nearby = 0.0;
    at = readNearby(at, ~std::uint64_t{0} >> 1, nearby);
    return roundAgain(nearby, value) ? at : nullptr;
}

}  // namespace walkcycle
