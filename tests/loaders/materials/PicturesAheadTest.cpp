#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/PaintedText.h"
#include "loaders/TestFiles.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {

using testing::SizeIs;

// Noise does not pack: large enough for a thread of its own.
Image noise(unsigned seed) {
    constexpr int kSize = 300;
    Image image{.width = kSize, .height = kSize, .hasAlpha = true, .rgba = {}};
    std::mt19937 random(seed);
    for (int i = 0; i < kSize * kSize * 4; ++i) image.rgba.push_back(static_cast<std::uint8_t>(random()));
    return image;
}

class PicturesAheadTest : public testing::Test {
protected:
    PicturesAheadTest() {
        for (unsigned i = 0; i < kCount; ++i) put(i, encodePng(noise(i)));
    }
    void put(unsigned picture, const Bytes& bytes) {
        writeFile(folder.path(std::to_string(picture) + ".png"), bytes);
    }
    Model load(const LoadOptions& options = {}) { return loadCollada(document, options); }

    static constexpr unsigned kCount = 5;
    TestFolder folder;
    std::string document = folder.write("painted.dae", withPictures(kCount));
};

// Which of several threads decodes a picture is left to chance, so often enough.
TEST_F(PicturesAheadTest, eachTextureGetsItsOwnPicture) {
    for (int round = 0; round < 20; ++round) {
        const Model model = load();
        ASSERT_THAT(model.textures, SizeIs(kCount));
        for (unsigned i = 0; i < kCount; ++i) {
            ASSERT_TRUE(model.textures[i].image);
            EXPECT_EQ(model.textures[i].image->rgba, noise(i).rgba) << i;
        }
        EXPECT_THAT(PaintedText::warnings(model), SizeIs(0));
    }
}

TEST_F(PicturesAheadTest, aBrokenPictureIsToldOfOnceWhereItIsNamed) {
    Bytes broken = encodePng(noise(9));
    broken.resize(broken.size() / 2);
    put(3, broken);
    const Model model = load();
    const std::vector<Diagnostic> said = PaintedText::warnings(model);
    ASSERT_THAT(said, SizeIs(1));
    EXPECT_EQ(said[0].code, "WC0622");
    EXPECT_THAT(said[0].elementPath, testing::HasSubstr("image[id=i3]"));
    EXPECT_TRUE(model.textures[4].image);
}

TEST_F(PicturesAheadTest, theLimitOfAllPicturesTogetherHolds) {
    LoadOptions options;
    options.limits.maxTotalPixels = 300 * 300 * 2 + 1;
    const Model model = load(options);
    EXPECT_TRUE(model.textures[0].image && model.textures[1].image);
    EXPECT_FALSE(model.textures[2].image || model.textures[3].image || model.textures[4].image);
    EXPECT_THAT(PaintedText::warnings(model), SizeIs(3));
}

// The pictures that are being decoded must not outlive what they are decoded for.
TEST_F(PicturesAheadTest, aLoadThatFailsMeanwhileFailsAsEver) {
    LoadOptions options;
    options.limits.maxVertices = 2;
    EXPECT_THROW(load(options), LoadError);
}

}  // namespace
}  // namespace walkcycle
