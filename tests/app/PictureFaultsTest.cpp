#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "app/Faults.h"
#include "app/SmallDocuments.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;

// A triangle with a picture, "skin.png": what is wrong with it is a warning, and the rest is shown.
std::string paintedTriangle() {
    std::string text =
        liftedTriangle(R"(<bind_material><technique_common><instance_material symbol="m" target="#paint"/>
</technique_common></bind_material>)");
    text.replace(text.find("<triangles"), 10, "<triangles material=\"m\"");
    text.insert(text.find("<library_geometries>"),
                R"(<library_images><image id="skin"><init_from>skin.png</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON><technique sid="c"><lambert><diffuse>
<texture texture="skin" texcoord="UV"/></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="paint"><instance_effect url="#e"/></material></library_materials>
)");
    return text;
}

std::string bigEndian(std::uint32_t number, int bytes = 4) {
    std::string text;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += static_cast<char>(number >> shift);
    return text;
}

std::string littleEndian(std::uint32_t number, int bytes = 4) {
    const std::string text = bigEndian(number, bytes);
    return {text.rbegin(), text.rend()};
}

std::string zeros(std::size_t count) {
    return std::string(count, '\0');
}

// A few bytes each that claim to be a picture of gigabytes.
std::map<std::string, std::string> bombs() {
    const std::string four("\0\0\0\0", 4);
    return {
        {"png", "\x89PNG\r\n\x1a\n" + bigEndian(13) + "IHDR" + bigEndian(60000) + bigEndian(60000) +
                    std::string("\x08\x06\0\0\0", 5) + four + bigEndian(8) + "IDAT" + zeros(8) + four},
        {"png of the largest size", "\x89PNG\r\n\x1a\n" + bigEndian(13) + "IHDR" + bigEndian(8000) +
                                        bigEndian(8000) + std::string("\x08\x06\0\0\0", 5) + four +
                                        bigEndian(8) + "IDAT" + zeros(8) + four},
        {"gif", "GIF89a" + littleEndian(65535, 2) + littleEndian(65535, 2) + zeros(3) + ",    " + zeros(20)},
        {"psd", "8BPS" + bigEndian(1, 2) + zeros(6) + bigEndian(4, 2) + bigEndian(300000) +
                    bigEndian(300000) + bigEndian(8, 2) + bigEndian(3, 2) + zeros(20)},
        {"tga", zeros(2) + "\x02" + zeros(9) + littleEndian(65535, 2) + littleEndian(65535, 2) + "\x20\x08"},
        {"bmp", "BM" + littleEndian(54) + zeros(4) + littleEndian(54) + littleEndian(40) +
                    littleEndian(0x7FFFFFFF) + littleEndian(0x7FFFFFFF) + littleEndian(1, 2) +
                    littleEndian(32, 2) + zeros(24)},
        {"jpeg", "\xff\xd8\xff\xc0" + bigEndian(17, 2) + "\x08" + bigEndian(65535, 2) + bigEndian(65535, 2) +
                     "\x03" + std::string("\1\x11\0\2\x11\0\3\x11\0", 9) + zeros(10)},
        {"pnm", "P6\n1000000 1000000\n255\n" + zeros(20)},
        {"hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000 +X 1000000\n" + zeros(20)},
        {"webp",
         "RIFF" + littleEndian(22) + "WEBPVP8X" + littleEndian(10) + zeros(4) + "\xff\xff\xff\xff\xff\xff"},
    };
}

// In so little memory that nothing of what they claim can be made.
std::vector<std::string> inLittleMemory() {
#ifdef WALKCYCLE_ADDRESS_SANITIZER
    return {};
#else
    return {"/usr/bin/prlimit", "--as=" + std::to_string(100 << 20)};
#endif
}

class PictureFaultsTest : public testing::Test {
protected:
    PictureFaultsTest() { writeFile(document, bytesOf(paintedTriangle())); }
    void expectWarning(const std::string& what, const testing::Matcher<std::string>& says) {
        const Ran ran = runWalkcycle({"check", document}, "", {}, inLittleMemory());
        EXPECT_EQ(ran.exitCode, 0) << what << ": " << ran.err;
        EXPECT_THAT(ran.err, says) << what;
        EXPECT_THAT(ran.err, HasSubstr("lift.dae:7: warning")) << what;
    }
    TestFolder folder;
    std::string document = folder / "lift.dae", picture = folder / "skin.png";
};

TEST_F(PictureFaultsTest, aPictureThatIsNotThereOrIsNone) {
    expectWarning("missing", HasSubstr("WC0620: the picture 'skin.png' is not there"));
    writeFile(picture, {});
    expectWarning("empty", AllOf(HasSubstr("WC0622"), HasSubstr("0 bytes")));
    writeFile(picture, bytesOf("<html>404 Not Found</html>"));
    expectWarning("a page of text", AllOf(HasSubstr("WC0622"), HasSubstr("not a picture of a known kind")));
    std::filesystem::remove(picture);
    std::filesystem::create_directory(picture);
    expectWarning("a folder", HasSubstr("WC0620"));
    std::filesystem::remove(picture);
    ASSERT_EQ(::mkfifo(picture.c_str(), 0600), 0);
    expectWarning("a pipe", HasSubstr("WC0620"));
    std::filesystem::remove(picture);
    ASSERT_EQ(::symlink("skin.png", picture.c_str()), 0);
    expectWarning("a link to itself", AnyOf(HasSubstr("WC0620"), HasSubstr("WC0208")));
}

TEST_F(PictureFaultsTest, aPictureThatIsCutShort) {
    Image image{.width = 64, .height = 64, .hasAlpha = false, .rgba = {}};
    for (int i = 0; i < 64 * 64 * 4; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i * i / 7));
    Bytes png = encodePng(image);
    png.resize(png.size() / 2);
    writeFile(picture, png);
    expectWarning("half a picture", HasSubstr("WC0622"));
}

TEST_F(PictureFaultsTest, aPictureThatMayNotBeRead) {
    writeFile(picture, bytesOf("x"));
    ASSERT_EQ(::chmod(picture.c_str(), 0), 0);
    const Ran ran = runWalkcycle({"check", document}, "", {}, withoutPrivileges());
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_THAT(ran.err, AllOf(HasSubstr("WC0624"), HasSubstr("Permission denied")));
}

TEST_F(PictureFaultsTest, bombsAreRefusedByWhatTheyClaim) {
    for (const auto& [kind, bytes] : bombs()) {
        writeFile(picture, bytesOf(bytes));
        expectWarning(kind, AnyOf(HasSubstr("WC0622"), HasSubstr("WC0803")));
    }
}

TEST_F(PictureFaultsTest, aPictureOverTheLimitSaysHowToAllowIt) {
    Image image{.width = 20, .height = 1, .hasAlpha = false, .rgba = Bytes(80, 255)};
    writeFile(picture, encodePng(image));
    const Ran ran = runWalkcycle({"check", document, "--limit", "image-dimension=19"});
    EXPECT_THAT(ran.err, AllOf(HasSubstr("WC0803"), HasSubstr("--limit image-dimension=N")));
    EXPECT_THAT(runWalkcycle({"check", document, "--limit", "image-dimension=20"}).err,
                testing::Not(HasSubstr("WC0803")));
}

}  // namespace
}  // namespace walkcycle
