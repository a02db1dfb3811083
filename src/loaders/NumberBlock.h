#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "loaders/PlainNumber.h"
#include "loaders/Words.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace walkcycle {

// 64 characters of a list of indices, looked over all at once: they are so short that to look for the end of each takes
// longer than to read it. (Numbers with a point are not; looked over like this they took a fifth longer.) Each mask has a
// bit for each character, the lowest for the first.
class NumberBlock {
public:
    static constexpr std::ptrdiff_t kSize = 64;

    explicit NumberBlock(const char* at);

    // Where a word begins, and where white space does; in turns, a word first, as if white space were before the block.
    std::uint64_t edges() const { return spaces_ ^ (spaces_ << 1 | 1); }

    // The word of the characters [from, to); false where it is not one to eight digits. Of the seven characters behind
    // its first some may be looked at as well.
    bool read(unsigned from, unsigned to, std::int32_t& value) const;

private:
    const char* start_;
    std::uint64_t spaces_ = 0, digits_ = 0;
};

inline NumberBlock::NumberBlock(const char* at) : start_(at) {
#ifdef __SSE2__
    const auto bits = [](__m128i isSo, int shift) {
        return std::uint64_t{static_cast<std::uint16_t>(_mm_movemask_epi8(isSo))} << shift;
    };
    const auto atMost = [](__m128i some, char most) {
        return _mm_cmpeq_epi8(_mm_min_epu8(some, _mm_set1_epi8(most)), some);
    };
    for (int i = 0; i < kSize; i += 16) {
        const __m128i some = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at + i));
        spaces_ |= bits(atMost(some, ' '), i);
        digits_ |= bits(atMost(_mm_sub_epi8(some, _mm_set1_epi8('0')), 9), i);
    }
#else
    for (int i = 0; i < kSize; ++i) {
        spaces_ |= std::uint64_t{isWhiteSpace(at[i])} << i;
        digits_ |= std::uint64_t{isDigit(at[i])} << i;
    }
#endif
}

inline bool NumberBlock::read(unsigned from, unsigned to, std::int32_t& value) const {
    const unsigned length = to - from;
    const std::uint64_t word = ~std::uint64_t{0} >> (kSize - length) << from;
    if (length > 8 || (digits_ & word) != word) return false;
    value = static_cast<std::int32_t>(joinDigits(eightDigits(start_ + from) << (64 - 8 * length)));
    return true;
}

}  // namespace walkcycle
