#include <array>
#include <bit>
#include <cfloat>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/text/NumberParser.h"

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
    EXPECT_THAT(numbers<double>("0." + std::string(400, '0') + "1e+9 1e-99999999999999999999"),
                ElementsAre(0.0, 0.0));
}

// Too large is not too small, whichever way its exponent points.
TEST(NumberParserTest, manyDigitsBeforeASmallExponentAreAFault) {
    EXPECT_FALSE(isNumber(std::string(320, '6') + "e-4"));
    EXPECT_FALSE(isNumber("1e99999999999999999999"));
    EXPECT_TRUE(isNumber(std::string(320, '6') + "e-319"));
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

// The quick way multiplies up to eighteen digits by up to 1e22.
TEST(NumberParserTest, aListHoldsNothingThatNoFloatHolds) {
    const std::string text =
        "666683646333333213e22 -999999999999999999e21 340282346638528859e21 9007199254740991e22 7";
    std::vector<float> floats;
    std::vector<double> doubles;
    std::vector<NumberFault> faults;
    parseNumbers(text, floats, faults);
    EXPECT_THAT(floats, ElementsAre(0.0f, 0.0f, 3.40282346638528859e38f, 9007199254740991e22f, 7.0f));
    parseNumbers(text, doubles, faults);
    EXPECT_THAT(doubles, ElementsAre(0.0, 0.0, 3.40282346638528859e38, 9007199254740991e22, 7.0));
    ASSERT_THAT(faults, SizeIs(4));
    for (const NumberFault& fault : faults)
        EXPECT_THAT(fault.token, testing::EndsWith(fault.index == 0 ? "e22" : "e21"));
}

// What from_chars says of a word; nothing where it is no number, too large, or too small for a float.
template <typename T>
std::optional<T> judged(std::string_view word) {
    T value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = end == word.data() + word.size() && error == std::errc{};
    if (std::is_floating_point_v<T> && std::abs(static_cast<double>(value)) > FLT_MAX) return std::nullopt;
    return whole ? std::optional<T>(value) : std::nullopt;
}

// Reads all words as one list, and each must be what from_chars makes of it, to the last bit.
template <typename T>
void expectAsJudged(const std::vector<std::string>& words) {
    std::string text;
    std::vector<T> wanted, found;
    for (const std::string& word : words) {
        const std::optional<T> value = judged<T>(word);
        if (!value) continue;
        wanted.push_back(*value);
        text += word + (words.size() % 2 == 0 ? " " : "\r\n\t");
    }
    std::vector<NumberFault> faults;
    parseNumbers(text, found, faults);
    EXPECT_THAT(faults, SizeIs(0));
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_EQ(std::memcmp(&found[i], &wanted[i], sizeof(T)), 0) << found[i] << " for " << wanted[i];
}

void expectAllAsJudged(const std::vector<std::string>& words) {
    expectAsJudged<float>(words);
    expectAsJudged<double>(words);
    expectAsJudged<std::int32_t>(words);
}

// Up to so many digits with a point somewhere among them, and perhaps an exponent.
std::string randomWord(std::mt19937& random, unsigned mostDigits, int mostExponent) {
    std::string word = random() % 2 == 0 ? "-" : "";
    const unsigned digits = 1 + static_cast<unsigned>(random()) % mostDigits;
    const unsigned point = static_cast<unsigned>(random()) % (2 * digits);
    for (unsigned i = 0; i < digits; ++i) {
        if (i == point) word += '.';
        word += static_cast<char>('0' + random() % 10);
    }
    if (random() % 4 == 0)
        word += (random() % 2 == 0 ? "e" : "E") +
                std::to_string(static_cast<int>(random() % 100) * mostExponent / 100 - mostExponent / 2);
    return word;
}

TEST(NumberParserTest, aMillionRandomNumbersAreReadToTheLastBit) {
    std::mt19937 random(1);
    for (const unsigned mostDigits : {3u, 8u, 12u, 17u, 25u}) {
        std::vector<std::string> words;
        for (int i = 0; i < 200'000; ++i)
            words.push_back(randomWord(random, mostDigits, mostDigits == 8 ? 20 : 90));
        expectAllAsJudged(words);
    }
}

TEST(NumberParserTest, numbersHalfwayBetweenTwoFloatsAreReadToTheLastBit) {
    std::mt19937 random(2);
    std::vector<std::string> words;
    for (int i = 0; i < 30'000; ++i) {
        const auto bits = static_cast<std::uint32_t>(random()) % 0x7F000000u;
        const double a = std::bit_cast<float>(bits), b = std::bit_cast<float>(bits + 1);
        for (const int digits : {15, 16, 17, 18, 20, 40}) {
            std::array<char, 400> text;
            std::snprintf(text.data(), text.size(), "%.*g", digits, (a + b) / 2);
            words.emplace_back(text.data());
            std::snprintf(text.data(), text.size(), "%.*f", digits, (a + b) / 2);
            words.emplace_back(text.data());
        }
    }
    expectAllAsJudged(words);
}

TEST(NumberParserTest, numbersAtTheEdgesOfTheQuickWayAreReadToTheLastBit) {
    expectAllAsJudged({"9007199254740991",
                       "9007199254740992",
                       "9007199254740993",
                       "9007199254740993e22",
                       "9007199254740993e23",
                       "-9007199254740993e-22",
                       "1e22",
                       "1e23",
                       "8.5e-23",
                       "123456789012345678",
                       "1234567890123456789",
                       "0.000000000000000001",
                       "0.0000000000000000001",
                       "16777217",
                       "16777219",
                       "1.000000059604644775390625",
                       "0.1",
                       "7.0064923216240854e-46",
                       "1.17549435e-38",
                       "3.4028235e38",
                       "-0",
                       "-0.0",
                       "0e9999",
                       "0e-9999",
                       "0e99999",
                       "12345678",
                       "1234567",
                       "-2147483648",
                       "2147483647",
                       "00000000012",
                       "1.",
                       ".5",
                       "-.5e3",
                       "5.e-1",
                       "1.12345678",
                       "1.1234567812345678"});
}

TEST(NumberParserTest, aListEndsWhereItsTextEnds) {
    for (std::size_t words = 1; words < 20; ++words)
        for (const std::string word : {"1", "-0.5", "0.12345678", "123456789012345678901234567890"}) {
            std::string text = " ";
            for (std::size_t i = 0; i < words; ++i) text += word + (i + 1 < words ? " " : "");
            const std::vector<char> exact(text.begin(),
                                          text.end());  // the sanitizer sees what is read behind it
            EXPECT_THAT(numbers<double>({exact.data(), exact.size()}), SizeIs(words)) << text;
            EXPECT_THAT(numbers<float>({exact.data(), exact.size()}), SizeIs(words)) << text;
        }
}

TEST(NumberParserTest, aVeryLongListComesOutInOrderWithItsFaultsWhereTheyAre) {
    constexpr std::size_t kCount = 400'000;
    std::string text;
    std::vector<std::size_t> offsets;
    for (std::size_t i = 0; i < kCount; ++i) {
        offsets.push_back(text.size());
        text += (i % 30'000 == 29'999 ? "x" : std::to_string(i)) + " ";
    }
    std::vector<std::int32_t> values{-1};
    std::vector<NumberFault> faults;
    parseNumbers(text, values, faults);
    ASSERT_THAT(values, SizeIs(kCount + 1));
    for (std::size_t i = 0; i < kCount; ++i)
        ASSERT_EQ(values[i + 1], i % 30'000 == 29'999 ? 0 : static_cast<std::int32_t>(i));
    ASSERT_THAT(faults, SizeIs(13));
    for (std::size_t i = 0; i < faults.size(); ++i) {
        EXPECT_EQ(faults[i].index, 29'999 + 30'000 * i);
        EXPECT_EQ(faults[i].offset, offsets[faults[i].index]);
        EXPECT_EQ(faults[i].token, "x");
    }
}

TEST(NumberParserTest, ofAVeryLongListTheFirstFaultsAreKept) {
    std::string text;
    for (int i = 0; i < 1'200'000; ++i) text += "x ";
    std::vector<double> values;
    std::vector<NumberFault> faults;
    parseNumbers(text, values, faults);
    EXPECT_THAT(values, SizeIs(1'200'000));
    ASSERT_THAT(faults, SizeIs(kMaxFaults));
    EXPECT_EQ(faults.back().index, kMaxFaults - 1);
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
