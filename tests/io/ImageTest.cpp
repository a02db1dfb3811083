#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/Image.h"
#include "io/TestFolder.h"

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
