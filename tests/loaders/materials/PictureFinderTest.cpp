#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <unistd.h>

#include "loaders/MaterialsOf.h"
#include "loaders/materials/PictureFinder.h"
#include "walkcycle/io/File.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {
namespace fs = std::filesystem;

// A folder of its own with a document in "model", and pictures about it.
class PictureFinderTest : public testing::Test {
protected:
    void SetUp() override {
        const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ =
            fs::temp_directory_path() / ("walkcycle-pictures-" + std::to_string(getpid()) + test->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "model");
        const std::string text = "<COLLADA version=\"1.4.1\"><asset/></COLLADA>";
        writeFile(document(), Bytes(text.begin(), text.end()));
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string document() const { return (folder_ / "model" / "walker.dae").string(); }

    void put(const std::string& path) {
        fs::create_directories((folder_ / "model" / path).parent_path());
        const Image dot{.width = 1, .height = 1, .hasAlpha = true, .rgba = {1, 2, 3, 4}};
        writeFile((folder_ / "model" / path).string(), encodePng(dot));
    }

    struct Search {
        explicit Search(const std::string& path, LoadOptions options = {})
            : file(path, std::move(options)), finder(file.context) {}
        PictureFinder::Picture find(const std::string& uri) { return finder.find(file.root, uri); }
        std::string nameOf(const std::string& uri) { return fs::path(find(uri).path).filename().string(); }
        MaterialsOf file;
        PictureFinder finder;
    };

    fs::path folder_;
};

TEST_F(PictureFinderTest, findsWhatTheFileSaysWithoutAWord) {
    put("my skin.png");
    put("a+b.png");
    put("sub/skin.png");
    Search search(document());

    for (const char* uri :
         {"my%20skin.png", "my skin.png", "./my%20skin.png", "not/there/../../my%20skin.png", "a+b.png",
          "sub/skin.png", "sub\\skin.png", "file:my%20skin.png"})
        EXPECT_TRUE(search.find(uri).image) << uri;
    EXPECT_TRUE(search.file.diagnostics.all().empty());
}

TEST_F(PictureFinderTest, anAbsolutePathInsideTheDocumentsFolderIsFine) {
    put("skin.png");
    Search search(document());

    EXPECT_TRUE(search.find("file://" + (folder_ / "model" / "skin.png").string()).image);
    EXPECT_TRUE(search.file.diagnostics.all().empty());
}

TEST_F(PictureFinderTest, ofAPathOnSomebodyElsesDiskTheNameCounts) {
    put("skin.png");
    Search search(document());

    for (const char* uri : {"file:///C:/Users/me/skin.png", "C:\\Users\\me\\skin.png", "/home/me/skin.png",
                            "http://x.org/skin.png"})
        EXPECT_EQ(search.nameOf(uri), "skin.png") << uri;
    EXPECT_GE(search.file.warnings(Code::PictureGuessed), 3);
    EXPECT_EQ(search.file.warnings(Code::ExternalRefused), 0);
}

TEST_F(PictureFinderTest, upperAndLowerCaseMayDiffer) {
    put("Skin.PNG");
    put("sub/Hair.png");
    Search search(document());

    EXPECT_EQ(search.nameOf("skin.png"), "Skin.PNG");
    EXPECT_EQ(search.nameOf("sub/hair.png"), "Hair.png");
    EXPECT_EQ(search.file.warnings(Code::PictureGuessed), 2);
}

TEST_F(PictureFinderTest, theUsualFoldersAreSearched) {
    put("textures/skin.png");
    put("other.png");
    Search search(document());

    EXPECT_EQ(search.nameOf("skin.png"), "skin.png");
}

TEST_F(PictureFinderTest, theSameNameWithAnotherEndingWillDo) {
    put("Skin.png");
    put("other.png");
    Search search(document());

    EXPECT_EQ(search.nameOf("textures/skin.dds"), "Skin.png");
}

TEST_F(PictureFinderTest, theOnlyPictureOfTheFolderIsTheLastResort) {
    put("Untitled.png");
    {
        Search search(document());
        EXPECT_EQ(search.nameOf("skin.png"), "Untitled.png");
    }
    put("Another.png");
    Search search(document());
    EXPECT_EQ(search.find("skin.png").path, "");
    EXPECT_EQ(search.file.warnings(Code::PictureMissing), 1);
}

TEST_F(PictureFinderTest, nothingOutsideTheFolderIsOpenedUnlessAllowed) {
    put("../secret.png");
    {
        Search search(document());
        EXPECT_FALSE(search.find("../secret.png").image);
        EXPECT_EQ(search.file.warnings(Code::ExternalRefused), 1);
    }
    LoadOptions options;
    options.allowedPaths = {folder_.string()};
    Search search(document(), options);
    EXPECT_TRUE(search.find("../secret.png").image);
    EXPECT_TRUE(search.find((folder_ / "secret.png").string()).image);
}

TEST_F(PictureFinderTest, theNetworkIsNeverAsked) {
    Search search(document());

    EXPECT_FALSE(search.find("http://127.0.0.1:9/skin.png").image);
    EXPECT_EQ(search.file.warnings(Code::PictureRemote), 1);
}

TEST_F(PictureFinderTest, aPictureThatIsNotThereIsReportedOnce) {
    Search search(document());
    search.find("skin.png");
    search.find("skin.png");

    ASSERT_EQ(search.file.diagnostics.all().size(), 1u);
    EXPECT_EQ(search.file.diagnostics.all()[0].repeats, 0);
}

TEST_F(PictureFinderTest, aBrokenPictureIsReportedWithItsReason) {
    writeFile((folder_ / "model" / "skin.png").string(), Bytes{'h', 'e', 'l', 'l', 'o'});
    Search search(document());

    EXPECT_FALSE(search.find("skin.png").image);
    EXPECT_EQ(search.file.warnings(Code::PictureBroken), 1);
}

TEST_F(PictureFinderTest, withoutDecodingItIsStillSeenThatAPictureIsNone) {
    put("skin.png");
    writeFile((folder_ / "model" / "text.png").string(), Bytes(100, 'a'));
    LoadOptions options;
    options.loadImages = false;
    Search search(document(), options);

    EXPECT_FALSE(search.find("skin.png").image);
    EXPECT_NE(search.find("skin.png").path, "");
    EXPECT_TRUE(search.file.diagnostics.all().empty());
    search.find("text.png");
    EXPECT_EQ(search.file.warnings(Code::PictureBroken), 1);
}

TEST_F(PictureFinderTest, oneFileIsDecodedOnceHoweverItIsWritten) {
    put("skin.png");
    Search search(document());

    EXPECT_EQ(search.find("skin.png").image, search.find("./skin.png").image);
}

TEST_F(PictureFinderTest, manyPicturesAreNotMoreThanTheirLimitTogether) {
    LoadOptions options;
    options.limits.maxTotalPixels = 4;
    for (const char* name : {"1.png", "2.png", "3.png", "4.png", "5.png"}) put(name);
    Search search(document(), options);

    for (const char* name : {"1.png", "2.png", "3.png", "4.png"}) EXPECT_TRUE(search.find(name).image);
    EXPECT_FALSE(search.find("5.png").image);
    EXPECT_EQ(search.file.warnings(Code::PictureOverLimit), 1);
}

TEST_F(PictureFinderTest, theUsersPictureComesFirst) {
    put("mine.png");
    LoadOptions options;
    options.texture = (folder_ / "model" / "mine.png").string();
    {
        Search search(document(), options);
        EXPECT_TRUE(search.finder.chosenByUser().image);
    }
    options.texture += ".not";
    Search search(document(), options);
    EXPECT_FALSE(search.finder.chosenByUser().image);
    EXPECT_EQ(search.file.warnings(Code::PictureUnreadable), 1);
}

TEST_F(PictureFinderTest, aReferenceWithoutANameIsMissingWithoutAnyGuess) {
    put("skin.png");
    Search search(document());

    for (const char* uri : {"textures/", "#skin", "http://x.org/"})
        EXPECT_EQ(search.find(uri).path, "") << uri;
    EXPECT_EQ(search.file.warnings(Code::PictureMissing), 2);
    EXPECT_EQ(search.file.warnings(Code::PictureRemote), 1);
}

TEST_F(PictureFinderTest, aPerCentSignThatIsNoEscapeBelongsToTheName) {
    put("50%25.png");
    put("other.png");
    put("a");
    Search search(document());

    EXPECT_EQ(search.nameOf("50%25.png"), "50%25.png");
    EXPECT_EQ(search.file.warnings(Code::PictureGuessed), 1);
    EXPECT_EQ(search.nameOf("a"), "a");
}

TEST_F(PictureFinderTest, theNameBesideTheDocumentCountsInAnyCaseAndFromAnyFolder) {
    put("Skin.PNG");
    put("other.png");
    Search search(document());

    EXPECT_EQ(search.nameOf("not/there/skin.png"), "Skin.PNG");
    EXPECT_EQ(search.file.warnings(Code::PictureGuessed), 1);
}

TEST_F(PictureFinderTest, whoHasLostAThousandPicturesHasMovedThemAll) {
    put("textures/skin.png");
    Search search(document());
    for (int i = 0; i < 1000; ++i) search.find("lost" + std::to_string(i) + ".png");

    EXPECT_EQ(search.find("skin.png").path, "");
    EXPECT_EQ(search.file.warnings(Code::PictureGuessed), 0);
}

TEST_F(PictureFinderTest, withoutDecodingATargaIsKnownByItsNameAndAnEmptyFileIsNoPicture) {
    const auto bytes = [&](const char* name, std::size_t count) {
        writeFile((folder_ / "model" / name).string(), Bytes(count, 0));
        return name;
    };
    LoadOptions options;
    options.loadImages = false;
    Search search(document(), options);

    search.find(bytes("skin.TGA", 100));
    EXPECT_TRUE(search.file.diagnostics.all().empty());
    search.find(bytes("short.tga", 18));
    search.find(bytes("empty.png", 0));
    EXPECT_EQ(search.file.warnings(Code::PictureBroken), 2);
}

}  // namespace
}  // namespace walkcycle
