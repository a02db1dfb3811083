#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace walkcycle {

// The numbers that exporters write, in one pass over their characters; what is unusual in any way (very many digits, a
// large exponent, a plus sign, no number at all) is left to the caller. `at` is the first character of a word that white
// space ends, and of the seven characters behind that may be looked at as well. Each gives where the word ends, or null
// where it is not as expected.

// (Within a function they would be copied to the stack for each number.)
inline constexpr std::array<std::uint32_t, 9> kWholePowers{1,      10,      100,      1000,     10000,
                                                           100000, 1000000, 10000000, 100000000};
inline constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

inline bool isDigit(char c) {
    return static_cast<unsigned char>(c - '0') < 10;
}

// Every control character counts as white space: exporters have written all of them.
inline bool isNumberSpace(char c) {
    return static_cast<unsigned char>(c) <= ' ';
}

// The digits at the start of eight characters and how many they are. All at once, where the machine's first byte is the
// lowest: each byte becomes its digit, those from the first other character on are shifted out, then neighbours are
// joined to pairs, fours and eight.
inline int readUpToEightDigits(const char* at, std::uint32_t& number) {
    if constexpr (std::endian::native == std::endian::little) {
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, at, 8);
        bytes ^= 0x3030303030303030u;
        const std::uint64_t others = ((bytes + 0x7676767676767676u) | bytes) & 0x8080808080808080u;
        const int bits = others == 0 ? 64 : std::countr_zero(others) & ~7;
        if (bits == 0) return static_cast<int>(number = 0);
        bytes <<= 64 - bits;
        bytes = bytes * 10 + (bytes >> 8);
        bytes = (bytes & 0x000000FF000000FFu) * 0x000F424000000064u +
                ((bytes >> 16) & 0x000000FF000000FFu) * 0x0000271000000001u;
        number = static_cast<std::uint32_t>(bytes >> 32);
        return bits / 8;
    } else {
        int count = 0;
        for (number = 0; count < 8 && isDigit(at[count]); ++count)
            number = number * 10 + static_cast<std::uint32_t>(at[count] - '0');
        return count;
    }
}

inline const char* readPlain(const char* at, std::int32_t& value) {
    const bool negative = *at == '-';
    at += negative;
    std::uint32_t number = 0;
    const int count = readUpToEightDigits(at, number);
    at += count;
    if (count == 0 || count == 8 || !isNumberSpace(*at)) return nullptr;
    value = negative ? -static_cast<std::int32_t>(number) : static_cast<std::int32_t>(number);
    return at;
}

// A whole number times a power of ten.
struct PlainDecimal {
    static constexpr int kMostDigits = 18;  // a longer number may not fit
    std::uint64_t number = 0;
    int exponent = 0;
    bool negative = false;
};

// What stands behind an 'e'.
inline const char* readExponent(const char* at, int& exponent) {
    const bool negative = *at == '-';
    if (negative || *at == '+') ++at;
    std::uint32_t number = 0;
    const int count = readUpToEightDigits(at, number);
    at += count;
    if (count == 0 || count > 4 || !isNumberSpace(*at)) return nullptr;
    exponent += negative ? -static_cast<int>(number) : static_cast<int>(number);
    return at;
}

inline const char* readDecimal(const char* at, PlainDecimal& decimal) {
    decimal.negative = *at == '-';
    at += decimal.negative;
    const char* const first = at;
    for (; isDigit(*at); ++at) decimal.number = decimal.number * 10 + static_cast<std::uint64_t>(*at - '0');
    auto digits = at - first;
    if (*at == '.') {
        const char* const point = at++;
        std::uint32_t eight = 0;
        int count = 8;
        for (; count == 8; at += count) {
            count = readUpToEightDigits(at, eight);
            decimal.number = decimal.number * kWholePowers[static_cast<std::size_t>(count)] + eight;
        }
        digits += at - point - 1;
        decimal.exponent = -static_cast<int>(at - point - 1);
    }
    if (digits == 0 || digits > PlainDecimal::kMostDigits) return nullptr;
    if (isNumberSpace(*at)) return at;
    return *at == 'e' || *at == 'E' ? readExponent(at + 1, decimal.exponent) : nullptr;
}

// The double nearest to a decimal: with at most 53 bits and a power of ten that a double holds exactly, one operation
// rounds once (Clinger). False for others; `sloppy` takes more bits too, off by two units in the last place at most.
inline bool toDouble(const PlainDecimal& decimal, bool sloppy, double& value) {
    const std::uint64_t number = decimal.number;
    if (!sloppy && number > std::uint64_t{1} << 53) return false;
    const int power = number == 0 ? 0 : decimal.exponent;
    constexpr int kMostPower = static_cast<int>(kPowers.size()) - 1;
    if (power < -kMostPower || power > kMostPower) return false;
    const auto whole = static_cast<double>(static_cast<std::int64_t>(number));
    value = power < 0 ? whole / kPowers[static_cast<std::size_t>(-power)]
                      : whole * kPowers[static_cast<std::size_t>(power)];
    if (decimal.negative) value = -value;
    return true;
}

inline const char* readPlain(const char* at, double& value) {
    PlainDecimal decimal;
    at = readDecimal(at, decimal);
    return at && toDouble(decimal, false, value) ? at : nullptr;
}

// By way of the nearest double, or one beside it: the nearest float is the same, unless the double is about halfway
// between two floats. (None of these doubles is too small or too large for a normal float, but zero.)
inline const char* readPlain(const char* at, float& value) {
    PlainDecimal decimal;
    at = readDecimal(at, decimal);
    double nearby = 0.0;
    if (!at || !toDouble(decimal, true, nearby)) return nullptr;
    constexpr std::uint64_t kBitsBelow = (1u << 29) - 1, kHalf = 1u << 28, kSlack = 4;
    if ((std::bit_cast<std::uint64_t>(nearby) & kBitsBelow) - (kHalf - kSlack) <= 2 * kSlack) return nullptr;
    value = static_cast<float>(nearby);
    return at;
}

}  // namespace walkcycle
