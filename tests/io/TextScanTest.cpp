#include <algorithm>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "io/TextScan.h"

namespace walkcycle {
namespace {

TEST(TextScanTest, lineBreaksAreCountedInTextsOfAnyLength) {
    for (std::size_t size = 0; size < 600; ++size) {
        std::string text(size, 'x');
        for (std::size_t i = 0; i < size; i += 3) text[i] = '\n';
        EXPECT_EQ(countLineBreaks(text), (size + 2) / 3);
    }
    EXPECT_EQ(countLineBreaks(std::string(1000, '\n')), 1000u);
}

TEST(TextScanTest, theFirstOddCharacterIsFoundWhereverItStands) {
    for (std::size_t place = 0; place < 400; ++place) {
        std::string text(400, 'x');
        text[place] = '\xC3';
        EXPECT_EQ(findBeyondAscii(text), place);
        EXPECT_EQ(findBeyondAscii(text, place), place);
        EXPECT_EQ(findBeyondAscii(text, place + 1), text.size());
        EXPECT_EQ(findForbiddenControl(text), text.size());
        EXPECT_FALSE(isPlainText(text));
        text[place] = '\x01';
        EXPECT_EQ(findForbiddenControl(text), place);
        EXPECT_EQ(findBeyondAscii(text), text.size());
        EXPECT_FALSE(isPlainText(text));
    }
}

TEST(TextScanTest, tabsAndLineEndsAreNoForbiddenControlCharacters) {
    for (int c = 0; c < 256; ++c) {
        const std::string text(300, static_cast<char>(c));
        const bool forbidden = c < ' ' && c != '\t' && c != '\n' && c != '\r';
        EXPECT_EQ(findForbiddenControl(text), forbidden ? 0 : text.size()) << c;
        EXPECT_EQ(isPlainText(text), !forbidden && c < 0x80) << c;
    }
}

}  // namespace
}  // namespace walkcycle
