#include <string>
#include <string_view>

#include <gmock/gmock.h>

#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(WordsTest, wordsAreSplitAtWhiteSpaceOnly) {
    EXPECT_THAT(splitWords(" hip\tknee.L\r\nBip01-Spine "), ElementsAre("hip", "knee.L", "Bip01-Spine"));
    EXPECT_THAT(splitWords(" \n"), IsEmpty());
    EXPECT_EQ(trim("\n a b \t"), "a b");
    EXPECT_EQ(trim(" \n"), "");
}

TEST(WordsTest, asManyAreCountedAsAreSplit) {
    for (const char* text : {"", " ", "a", " a", "a ", "1 2\t3", "1\n\n2  "})
        EXPECT_EQ(countWords(text), splitWords(text).size()) << text;
}

TEST(WordsTest, eachWordIsFoundByItsNumber) {
    const std::string_view text = "\n0.5  -1\t2";
    EXPECT_EQ(startOfWord(text, 0), 1u);
    EXPECT_EQ(startOfWord(text, 1), text.find("-1"));
    EXPECT_EQ(startOfWord(text, 2), text.find('2'));
    EXPECT_EQ(startOfWord(text, 3), std::string_view::npos);
    EXPECT_EQ(startOfWord("", 0), std::string_view::npos);
}

TEST(WordsTest, whatIsPrintedIsOneLineOfWholeCharacters) {
    EXPECT_EQ(printable("first\nsecond\x1b[31m\x7f"), "first second [31m ");
    EXPECT_EQ(printable(std::string(200, 'x')), std::string(200, 'x'));
    EXPECT_EQ(printable(std::string(199, 'x') + "\u00e9 and more"), std::string(199, 'x') + "...");
}

}  // namespace
}  // namespace walkcycle
