#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "io/ImageDecoder.h"
#include "io/TestFolder.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Image gradient(int width, int height, bool hasAlpha) {
    Image image{.width = width, .height = height, .hasAlpha = hasAlpha, .rgba = {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {x * 7, y * 5, x + y, hasAlpha ? x * 3 : 255})
                image.rgba.push_back(static_cast<std::uint8_t>(value));
    return image;
}

Bytes tga(int width, int height, std::initializer_list<std::uint8_t> pixels) {
    Bytes bytes = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    for (const int size : {width, height}) {
        bytes.push_back(static_cast<std::uint8_t>(size & 0xFF));
        bytes.push_back(static_cast<std::uint8_t>(size >> 8));
    }
    bytes.insert(bytes.end(), {32, 8});
    bytes.insert(bytes.end(), pixels);
    return bytes;
}

Bytes seed(const std::string& name) {
    return readFile(WALKCYCLE_SOURCE_DIR "/fuzz/seeds/image/" + name, 1 << 20);
}

TEST(ImageTest, pngGivesBackEveryPixel) {
    for (const bool alpha : {false, true}) {
        const Image image = gradient(37, 23, alpha);
        const Image read = decodeImage(encodePng(image));
        EXPECT_EQ(read.width, 37);
        EXPECT_EQ(read.height, 23);
        EXPECT_EQ(read.hasAlpha, alpha);
        EXPECT_EQ(read.rgba, image.rgba);
    }
}

TEST(ImageTest, webpGivesBackEveryPixelAlsoWhereNothingCoversIt) {
    for (const bool alpha : {false, true}) {
        const Image image = gradient(37, 23, alpha);
        EXPECT_EQ(decodeImage(encodeWebp(image)).rgba, image.rgba);
    }
}

// What a PNG of 8 bits a channel holds, by the words of its specification, one byte at a time.
Bytes unfiltered(const Bytes& rows, int width, int height, int channels) {
    Bytes pixels;
    const int rowBytes = width * channels;
    const auto at = [&](int x, int y) -> int {
        return x < 0 || y < 0 ? 0 : pixels[static_cast<std::size_t>(y * rowBytes + x)];
    };
    for (int y = 0; y < height; ++y) {
        const std::size_t start = static_cast<std::size_t>(y * (rowBytes + 1));
        for (int x = 0; x < rowBytes; ++x) {
            const int a = at(x - channels, y), b = at(x, y - 1), c = at(x - channels, y - 1), p = a + b - c;
            const int pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
            const int guesses[] = {0, a, b, (a + b) / 2, pa <= pb && pa <= pc ? a : pb <= pc ? b : c};
            pixels.push_back(static_cast<std::uint8_t>(rows[start + 1 + static_cast<std::size_t>(x)] +
                                                       guesses[rows[start]]));
        }
    }
    return pixels;
}

void putChunk(Bytes& png, const std::string& name, const Bytes& data) {
    const auto number = [&](std::size_t value) {
        for (const int shift : {24, 16, 8, 0}) png.push_back(static_cast<std::uint8_t>(value >> shift));
    };
    number(data.size());
    png.insert(png.end(), name.begin(), name.end());
    png.insert(png.end(), data.begin(), data.end());
    number(0);  // a check sum that nobody asks for
}

// The rows as they are, each with its filter byte, packed into chunks of at most `part` bytes.
Bytes pngOf(const Bytes& rows, int width, int height, int channels, std::size_t part) {
    Bytes packed(compressBound(static_cast<uLong>(rows.size())));
    uLongf size = static_cast<uLongf>(packed.size());
    EXPECT_EQ(compress(packed.data(), &size, rows.data(), static_cast<uLong>(rows.size())), Z_OK);
    Bytes png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    putChunk(png, "IHDR",
             {0, 0, 0, static_cast<std::uint8_t>(width), 0, 0, 0, static_cast<std::uint8_t>(height), 8,
              static_cast<std::uint8_t>(channels == 3 ? 2 : 6), 0, 0, 0});
    for (std::size_t at = 0; at < size; at += part) {
        const auto begin = packed.begin() + static_cast<std::ptrdiff_t>(at);
        putChunk(png, "IDAT", Bytes(begin, begin + static_cast<std::ptrdiff_t>(std::min(part, size - at))));
    }
    putChunk(png, "IEND", {});
    return png;
}

TEST(ImageTest, everyFilterOfPngIsTakenBackAsItsSpecificationSays) {
    constexpr int width = 23, height = 40;
    for (const int channels : {3, 4}) {
        Bytes rows;
        std::uint32_t random = 1;
        for (int y = 0; y < height; ++y) {
            rows.push_back(static_cast<std::uint8_t>(y % 5));
            for (int x = 0; x < width * channels; ++x)
                rows.push_back(static_cast<std::uint8_t>((random = random * 1664525u + 1013904223u) >> 24));
        }
        const Bytes expected = unfiltered(rows, width, height, channels);
        for (const std::size_t part : {std::size_t{100}, std::size_t{100'000}}) {
            const Image image = decodeImage(pngOf(rows, width, height, channels, part));
            ASSERT_EQ(image.hasAlpha, channels == 4);
            Bytes read;
            for (std::size_t i = 0; i < image.rgba.size(); ++i)
                if (channels == 4 || i % 4 != 3) read.push_back(image.rgba[i]);
            EXPECT_EQ(read, expected);
            EXPECT_EQ(channels == 3, image.rgba[3] == 255 && image.rgba.back() == 255);
        }
    }
}

TEST(ImageTest, measuringAPngDecodesNoPixelsButSeesThatPartOfItIsMissing) {
    Bytes png = encodePng(gradient(37, 23, true));
    const Image size = measureImage(png);
    EXPECT_EQ(size.width, 37);
    EXPECT_EQ(size.height, 23);
    EXPECT_TRUE(size.hasAlpha && size.rgba.empty());
    EXPECT_THROW(measureImage(png, {.maxDimension = 36, .maxPixels = 10'000}), ImageTooLarge);
    png.resize(png.size() / 2);
    EXPECT_THROW(measureImage(png), ImageError);
    EXPECT_EQ(measureImage(encodeWebp(gradient(37, 23, true))).width, 37);
}

TEST(ImageTest, theSamePictureGivesTheSameBytes) {
    const Image image = gradient(64, 64, true);
    EXPECT_EQ(encodePng(image), encodePng(image));
    EXPECT_EQ(encodeWebp(image), encodeWebp(image));
}

TEST(ImageTest, aPictureWithoutPixelsIsNotWritten) {
    EXPECT_THROW(encodePng(Image{}), ImageError);
    EXPECT_THROW(encodeWebp(Image{.width = 4, .height = 4, .hasAlpha = false, .rgba = {1, 2, 3}}),
                 ImageError);
}

TEST(ImageTest, eighteenBytesThatClaimGigabytesAreRefusedBeforeAnythingIsMade) {
    EXPECT_THAT([] { decodeImage(tga(0xFFFF, 0xFFFF, {})); },
                ThrowsMessage<ImageError>(HasSubstr("65535 x 65535")));
    EXPECT_THAT([] { decodeImage(tga(8000, 8000, {})); }, ThrowsMessage<ImageError>(HasSubstr("cut short")));
}

TEST(ImageTest, aChunkThatClaimsGigabytesCostsNothing) {
    Bytes png = encodePng(gradient(5, 3, false));
    const std::size_t idat =
        std::string_view(reinterpret_cast<const char*>(png.data()), png.size()).find("IDAT");
    png[idat - 4] = 0x3F;  // the chunk's length, highest byte first
    EXPECT_THAT([&] { decodeImage(png); }, ThrowsMessage<ImageError>(HasSubstr("outofmem")));
}

TEST(ImageTest, limitsAreCheckedFromTheHeader) {
    const Bytes png = encodePng(gradient(20, 10, false));
    EXPECT_EQ(decodeImage(png, {.maxDimension = 20, .maxPixels = 200}).width, 20);
    EXPECT_THROW(decodeImage(png, {.maxDimension = 19, .maxPixels = 200}), ImageError);
    EXPECT_THROW(decodeImage(png, {.maxDimension = 20, .maxPixels = 199}), ImageError);
    const Bytes webp = encodeWebp(gradient(20, 10, false));
    EXPECT_EQ(decodeImage(webp, {.maxDimension = 20, .maxPixels = 200}).width, 20);
    EXPECT_THROW(decodeImage(webp, {.maxDimension = 19, .maxPixels = 200}), ImageError);
}

TEST(ImageTest, whatIsNoPictureIsSaidToBeNone) {
    EXPECT_THAT([] { decodeImage({}); }, ThrowsMessage<ImageError>(HasSubstr("empty")));
    EXPECT_THAT([] { decodeImage(bytesOf("<html>404 Not Found</html>")); },
                ThrowsMessage<ImageError>(HasSubstr("not a picture")));
}

TEST(ImageTest, aPictureCutAnywhereThrowsOrGivesAWholeOne) {
    for (const Bytes& whole : {encodePng(gradient(16, 16, true)), encodeWebp(gradient(16, 16, true)),
                               tga(1, 1, {1, 2, 3, 4}), seed("small.jpeg"), seed("progressive.jpeg")})
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
            try {
                const Image image = decodeImage(cut);
                EXPECT_EQ(image.rgba.size(), static_cast<std::size_t>(image.width * image.height * 4));
            } catch (const ImageError&) {
            }
        }
}

TEST(ImageTest, jpegOfEitherKindShowsThePicture) {
    for (const char* name : {"small.jpeg", "progressive.jpeg"}) {
        const Image image = decodeImage(seed(name));
        EXPECT_EQ(image.width, 5);
        EXPECT_EQ(image.height, 3);
        EXPECT_FALSE(image.hasAlpha);
        EXPECT_NEAR(image.rgba[0], 0, 40);  // red rises to the right
        EXPECT_NEAR(image.rgba[4 * 4], 200, 40);
        EXPECT_NEAR(image.rgba[4 * 10 + 1], 160, 40);  // green to the bottom
        EXPECT_EQ(image.rgba[3], 255);
    }
}

TEST(ImageTest, aJpegThatEndsTooSoonIsRefused) {
    Bytes bytes = seed("small.jpeg");
    bytes.resize(bytes.size() - 20);
    EXPECT_THAT([&] { decodeImage(bytes); }, ThrowsMessage<ImageError>(HasSubstr("Premature end")));
}

// As stb_image's own decoder does not: it writes past a table of 256 codes.
TEST(ImageTest, aJpegWithTooManyHuffmanCodesIsRefused) {
    const Bytes bytes =
        readFile(WALKCYCLE_SOURCE_DIR "/fuzz/regressions/image/huffman-codes-past-the-table.jpeg", 1 << 20);
    EXPECT_THROW(decodeImage(bytes), ImageError);
}

TEST(ImageTest, aTgaWhoseAlphaIsEmptyIsOpaque) {
    const Image image = decodeImage(tga(2, 1, {10, 20, 30, 0, 40, 50, 60, 0}));
    EXPECT_FALSE(image.hasAlpha);
    EXPECT_THAT(image.rgba, testing::ElementsAre(30, 20, 10, 255, 60, 50, 40, 255));
}

}  // namespace
}  // namespace walkcycle
