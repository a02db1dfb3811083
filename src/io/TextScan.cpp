#include "io/TextScan.h"

#include <algorithm>
#include <cstdint>

namespace walkcycle {
namespace {

// Loops of a fixed length without a way out are what compilers make vectors of.
constexpr std::size_t kBlock = 128;

template <typename Test>
std::size_t findFirst(std::string_view text, std::size_t from, Test test) {
    std::size_t at = from;
    for (; at + kBlock <= text.size(); at += kBlock) {
        const char* const block = text.data() + at;
        unsigned char any = 0;
        for (std::size_t i = 0; i < kBlock; ++i) any |= test(static_cast<unsigned char>(block[i]));
        if (any) break;
    }
    while (at < text.size() && !test(static_cast<unsigned char>(text[at]))) ++at;
    return at;
}

}  // namespace

std::size_t countLineBreaks(std::string_view text) {
    std::size_t lines = 0;
    for (; text.size() >= kBlock; text.remove_prefix(kBlock)) {
        std::uint8_t inBlock = 0;
        for (std::size_t i = 0; i < kBlock; ++i)
            inBlock = static_cast<std::uint8_t>(inBlock + (text.data()[i] == '\n'));
        lines += inBlock;
    }
    return lines + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::size_t findBeyondAscii(std::string_view text, std::size_t from) {
    return findFirst(text, from, [](unsigned char c) { return static_cast<unsigned char>(c & 0x80); });
}

std::size_t findForbiddenControl(std::string_view text) {
    return findFirst(text, 0, [](unsigned char c) {
        return static_cast<unsigned char>((c < ' ') & (c != '\t') & (c != '\n') & (c != '\r'));
    });
}

}  // namespace walkcycle
