#include "io/TextScan.h"

#include <algorithm>
#include <cstdint>

namespace walkcycle {
namespace {

// Compilers vectorise loops that have a fixed length and no early exit.
constexpr std::size_t kBlock = 128;

unsigned char isForbiddenControl(unsigned char c) {
    return static_cast<unsigned char>((c < ' ') & (c != '\t') & (c != '\n') & (c != '\r'));
}

template <typename Test>
bool anyInBlock(const char* block, Test test) {
    unsigned char any = 0;
    for (std::size_t i = 0; i < kBlock; ++i) any |= test(static_cast<unsigned char>(block[i]));
    return any != 0;
}

unsigned char leastInBlock(const char* block) {
    unsigned char least = 0xFF;
    for (std::size_t i = 0; i < kBlock; ++i) least = std::min(least, static_cast<unsigned char>(block[i]));
    return least;
}

// Finds the first character for which `test` is true. `mayHold` is a quick test of a block: true for every
// block with such a character, and rarely for others.
template <typename MayHold, typename Test>
std::size_t findFirst(std::string_view text, std::size_t from, MayHold mayHold, Test test) {
    std::size_t at = from;
    for (; at + kBlock <= text.size(); at += kBlock)
        if (mayHold(text.data() + at) && anyInBlock(text.data() + at, test)) break;
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
    const auto test = [](unsigned char c) { return static_cast<unsigned char>(c & 0x80); };
    return findFirst(
        text, from, [](const char*) { return true; }, test);
}

std::size_t findForbiddenControl(std::string_view text) {
    const auto mayHold = [](const char* block) { return leastInBlock(block) < ' '; };
    return findFirst(text, 0, mayHold, isForbiddenControl);
}

bool isPlainText(std::string_view text) {
    std::string_view rest = text;
    for (; rest.size() >= kBlock; rest.remove_prefix(kBlock)) {
        unsigned char any = 0, least = 0xFF;
        for (std::size_t i = 0; i < kBlock; ++i) {
            const auto c = static_cast<unsigned char>(rest[i]);
            any |= c;
            least = std::min(least, c);
        }
        if (any >= 0x80 || (least < ' ' && anyInBlock(rest.data(), isForbiddenControl))) return false;
    }
    return std::none_of(rest.begin(), rest.end(), [](char c) {
        return static_cast<unsigned char>(c) >= 0x80 || isForbiddenControl(static_cast<unsigned char>(c));
    });
}

}  // namespace walkcycle
