#include <clocale>
#include <limits>

#include <gmock/gmock.h>

#include "loaders/NumberParser.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

template <typename T>
std::vector<T> numbers(std::string_view text) {
    std::vector<T> values;
    std::vector<NumberFault> faults;
    parseNumbers(text, values, faults);
    EXPECT_THAT(faults, SizeIs(0)) << text;
    return values;
}

bool isNumber(std::string_view text) {
    double value = 0.0;
    return parseNumber(text, value);
}

TEST(NumberParserTest, anyWhiteSpaceStandsBetweenNumbers) {
    EXPECT_THAT(numbers<float>(" \t1\n2\r\n3\v4\f 5 "), ElementsAre(1, 2, 3, 4, 5));
    EXPECT_THAT(numbers<std::int32_t>("\n1 -1\t0"), ElementsAre(1, -1, 0));
    EXPECT_THAT(numbers<double>(""), SizeIs(0));
    EXPECT_THAT(numbers<double>(" \n"), SizeIs(0));
}

TEST(NumberParserTest, everySpellingThatXmlSchemaAllowsIsRead) {
    EXPECT_THAT(numbers<double>("+1 .5 1. -0 1e2 1E-2 +.5e+1 007"),
                ElementsAre(1, 0.5, 1, 0, 100, 0.01, 5, 7));
    EXPECT_THAT(numbers<std::int32_t>("+3 -0 2147483647"), ElementsAre(3, 0, 2147483647));
}

TEST(NumberParserTest, whatIsTooSmallForTheTypeIsZero) {
    EXPECT_THAT(numbers<float>("1e-60 -1e-400"), ElementsAre(0.0f, 0.0f));
    EXPECT_THAT(numbers<double>("1e-400 0." + std::string(400, '0') + "1"), ElementsAre(0.0, 0.0));
}

TEST(NumberParserTest, whatIsNotWhollyANumberIsAFault) {
    for (const char* text :
         {"", "1.5x", "0x10", "1,5", "--1", "++1", "+-1", "+", "-", ".", "1e", "1 2", "one", "1_0"})
        EXPECT_FALSE(isNumber(text)) << text;
}

TEST(NumberParserTest, whatIsNotFiniteOrTooLargeIsAFault) {
    for (const char* text : {"INF", "-INF", "+INF", "NaN", "nan", "infinity", "1e400", "-1e400", "1e39"})
        EXPECT_FALSE(isNumber(text)) << text;
    EXPECT_FALSE(isNumber(std::string(500, '9')));
    EXPECT_TRUE(isNumber("3.4e38"));
}

TEST(NumberParserTest, aFractionIsNoIndex) {
    std::vector<std::int32_t> values;
    std::vector<NumberFault> faults;
    parseNumbers("3.7 1e3 4294967299 2", values, faults);
    EXPECT_THAT(faults, SizeIs(3));
    EXPECT_THAT(values, ElementsAre(0, 0, 0, 2));
}

TEST(NumberParserTest, aFaultSaysWhichTokenAndWhere) {
    std::vector<float> values{7.0f};
    std::vector<NumberFault> faults;
    parseNumbers("1 2\nbad 4", values, faults);
    EXPECT_THAT(values, ElementsAre(7, 1, 2, 0, 4));
    ASSERT_THAT(faults, SizeIs(1));
    EXPECT_EQ(faults[0].index, 2u);
    EXPECT_EQ(faults[0].offset, 4u);
    EXPECT_EQ(faults[0].token, "bad");
}

TEST(NumberParserTest, aThousandFaultsAreNotAllKept) {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += "x ";
    std::vector<float> values;
    std::vector<NumberFault> faults;
    parseNumbers(text, values, faults);
    EXPECT_THAT(values, SizeIs(1000));
    EXPECT_THAT(faults, SizeIs(kMaxFaults));
}

TEST(NumberParserTest, aCountIsNeitherNegativeNorAFractionNorOver64Bits) {
    std::uint64_t value = 0;
    EXPECT_TRUE(parseUnsigned(" 18446744073709551615 ", value));
    EXPECT_EQ(value, std::numeric_limits<std::uint64_t>::max());
    EXPECT_TRUE(parseUnsigned("+3", value));
    EXPECT_EQ(value, 3u);
    for (const char* text : {"-1", "3.7", "0x10", "18446744073709551616", "", "three"})
        EXPECT_FALSE(parseUnsigned(text, value)) << text;
}

TEST(NumberParserTest, aLocaleWithDecimalCommasChangesNothing) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    const bool hasComma = std::setlocale(LC_ALL, "de_DE.UTF-8") || std::setlocale(LC_ALL, "de_DE");
    EXPECT_THAT(numbers<double>("1.5"), ElementsAre(1.5));
    EXPECT_FALSE(isNumber("1,5"));
    std::setlocale(LC_ALL, before.c_str());
    if (!hasComma)
        GTEST_SKIP() << "no German locale is installed; the parser was asked under the default one";
}

TEST(NumberParserTest, wordsAreSplitAtWhiteSpaceOnly) {
    EXPECT_THAT(splitWords(" hip\tknee.L\r\nBip01-Spine "), ElementsAre("hip", "knee.L", "Bip01-Spine"));
    EXPECT_THAT(splitWords(" \n"), SizeIs(0));
    EXPECT_EQ(trim("\n a b \t"), "a b");
}

std::string aroundTheFirstFault(std::string_view text) {
    std::vector<double> values;
    std::vector<NumberFault> faults;
    parseNumbers(text, values, faults);
    return surroundings(text, faults.at(0));
}

TEST(NumberParserTest, aFaultIsShownWithTheFewNumbersAroundIt) {
    EXPECT_EQ(aroundTheFirstFault("9 8 7 6\n1,5 \t3 4 5 2"), "... 8 7 6 1,5 3 4 5 ...");
    EXPECT_EQ(aroundTheFirstFault("x 1 2"), "x 1 2");
    EXPECT_EQ(aroundTheFirstFault(" 1 2 x "), "1 2 x");
    EXPECT_EQ(aroundTheFirstFault(" x "), "");
    EXPECT_EQ(aroundTheFirstFault("1 " + std::string(1000, 'x') + " 2"),
              "1 " + std::string(20, 'x') + "... 2");
}

}  // namespace
}  // namespace walkcycle
