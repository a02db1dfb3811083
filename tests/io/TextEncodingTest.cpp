#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/TestFolder.h"
#include "io/TextEncoding.h"

namespace walkcycle {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Bytes utf16(std::u16string_view text, bool bigEndian, bool mark) {
    Bytes bytes;
    const auto put = [&](char16_t c) {
        const auto low = static_cast<std::uint8_t>(c), high = static_cast<std::uint8_t>(c >> 8);
        bytes.push_back(bigEndian ? high : low);
        bytes.push_back(bigEndian ? low : high);
    };
    if (mark) put(0xFEFF);
    for (const char16_t c : text) put(c);
    return bytes;
}

TEST(TextEncodingTest, utf8StaysAsItIsAndItsMarkGoes) {
    EXPECT_EQ(toUtf8(bytesOf("<a>Läufer 歩 😀</a>")), "<a>Läufer 歩 😀</a>");
    EXPECT_EQ(toUtf8(bytesOf("\xEF\xBB\xBF<a/>")), "<a/>");
    EXPECT_EQ(toUtf8({}), "");
}

TEST(TextEncodingTest, utf16IsReadInBothOrdersWithAndWithoutMark) {
    for (const bool bigEndian : {false, true})
        for (const bool mark : {false, true})
            EXPECT_EQ(toUtf8(utf16(u"<?xml version='1.0' encoding='UTF-16'?>\n<a>ä歩😀</a>", bigEndian, mark)),
                      "<?xml version='1.0' encoding='utf-8'?>\n<a>ä歩😀</a>");
}

TEST(TextEncodingTest, halfAUtf16CharacterIsAnErrorWithItsPlace) {
    Bytes odd = utf16(u"<a>\n</a>", false, true);
    odd.push_back('x');
    EXPECT_THAT([&] { toUtf8(odd); }, ThrowsMessage<EncodingError>(HasSubstr("byte 18")));
    try {
        toUtf8(utf16(u"<a>\n\xD800</a>", true, true));
        FAIL() << "a lone surrogate is no character";
    } catch (const EncodingError& error) {
        EXPECT_EQ(error.line, 2);
    }
}

TEST(TextEncodingTest, latin1IsReadWhereTheDeclarationSaysSo) {
    EXPECT_EQ(toUtf8(bytesOf("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><a>L\xE4ufer</a>")),
              "<?xml version=\"1.0\" encoding=\"utf-8\"?><a>Läufer</a>");
    EXPECT_EQ(toUtf8(bytesOf("<?xml version='1.0' encoding='windows-1252'?><a>\x80 \x93\x94</a>")),
              "<?xml version='1.0' encoding='utf-8'?><a>€ “”</a>");
}

TEST(TextEncodingTest, aWrongDeclarationOfUtf16DoesNotHideUtf8) {
    EXPECT_EQ(toUtf8(bytesOf("<?xml version=\"1.0\" encoding=\"utf-16\"?><a>ä</a>")),
              "<?xml version=\"1.0\" encoding=\"utf-8\"?><a>ä</a>");
}

TEST(TextEncodingTest, invalidUtf8IsAnErrorWithOffsetAndLine) {
    try {
        toUtf8(bytesOf("<a>\n\n\xE4</a>"));
        FAIL();
    } catch (const EncodingError& error) {
        EXPECT_THAT(error.what(), HasSubstr("byte 5"));
        EXPECT_EQ(error.line, 3);
    }
}

TEST(TextEncodingTest, invalidUtf8IsReadAsWindows1252WhereTheCallerCanSaySo) {
    bool guessed = false;
    EXPECT_EQ(toUtf8(bytesOf("<a>L\xE4ufer</a>"), &guessed), "<a>Läufer</a>");
    EXPECT_TRUE(guessed);
    toUtf8(bytesOf("<a>ä</a>"), &guessed);
    EXPECT_FALSE(guessed);
}

TEST(TextEncodingTest, overlongFormsSurrogatesAndCutSequencesAreNotUtf8) {
    for (const char* bad : {"\xC0\x80", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF0\x80\x80\x80",
                            "\xF4\x90\x80\x80", "\xF8", "\xE6\xAD", "\x80"})
        EXPECT_THROW(toUtf8(bytesOf(std::string("<a>longer than eight ") + bad)), EncodingError) << bad;
}

TEST(TextEncodingTest, aZeroCharacterWithinIsAnErrorAndPaddingAtTheEndIsNot) {
    EXPECT_THROW(toUtf8(bytesOf(std::string_view("<a>\0</a>", 8))), EncodingError);
    bool guessed = false, padded = false;
    EXPECT_EQ(toUtf8(bytesOf(std::string_view("<a/>\0\0\0", 7)), &guessed, &padded), "<a/>");
    EXPECT_TRUE(padded);
    toUtf8(bytesOf("<a/>"), &guessed, &padded);
    EXPECT_FALSE(padded);
}

TEST(TextEncodingTest, utf32IsRefusedByName) {
    EXPECT_THAT([] { toUtf8(bytesOf(std::string_view("\xFF\xFE\0\0<\0\0\0", 8))); },
                ThrowsMessage<EncodingError>(HasSubstr("UTF-32")));
}

TEST(TextEncodingTest, bytesThatAreUtf8AlreadyAreTheTextThemselves) {
    for (const char* text : {"<a>Läufer</a>", "<?xml version='1.0' encoding='UTF-8'?><a/>", "<a/>"}) {
        const Bytes bytes = bytesOf(text);
        EXPECT_EQ(asUtf8(bytes), text);
    }
    EXPECT_EQ(asUtf8(bytesOf("\xEF\xBB\xBF")), "");
    for (const std::string_view other :
         {std::string_view("<a/>\0", 5), std::string_view("<\0a\0", 4), std::string_view("<a>\xE4</a>"),
          std::string_view("<?xml encoding='latin1'?><a/>")})
        EXPECT_EQ(asUtf8(bytesOf(other)), std::nullopt) << other;
}

}  // namespace
}  // namespace walkcycle
