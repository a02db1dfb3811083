#include <filesystem>
#include <optional>
#include <string>

#include "loaders/LoadText.h"
#include "loaders/TestFiles.h"
#include "loaders/document/Surroundings.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const TestLoad& anyDocument() {
    static const TestLoad load("<COLLADA>\n<image/></COLLADA>");
    return load;
}

std::string read(Surroundings& surroundings, const std::string& path) {
    const std::optional<Bytes> bytes = surroundings.read(anyDocument().collada.child("image"), path);
    return bytes ? std::string(bytes->begin(), bytes->end()) : "nothing";
}

TEST(SurroundingsTest, onlyTheDocumentsFolderIsOpenUnlessAllowed) {
    const TestFolder folder;
    folder.write("doc/maps/skin.png", "inside");
    folder.write("secret.txt", "outside");
    folder.write("doctor/secret.txt", "outside");
    LoadOptions options;
    Diagnostics diagnostics;
    Surroundings surroundings(options, diagnostics);
    surroundings.useFolder(folder.path("doc"));
    EXPECT_EQ(read(surroundings, folder.path("doc/maps/skin.png")), "inside");
    EXPECT_EQ(read(surroundings, folder.path("doc/maps/../maps/skin.png")), "inside");
    EXPECT_THAT(diagnostics.all(), IsEmpty());
    EXPECT_EQ(read(surroundings, folder.path("doc/../secret.txt")), "nothing");
    EXPECT_EQ(read(surroundings, folder.path("doctor/secret.txt")), "nothing");
    EXPECT_THAT(diagnostics.all(),
                ElementsAre(says("WC0208", 2, "COLLADA/image"), says("WC0208", 2, "COLLADA/image")));
    options.allowedPaths = {folder.path("doctor")};
    EXPECT_EQ(read(surroundings, folder.path("doctor/secret.txt")), "outside");
    EXPECT_EQ(read(surroundings, folder.path("secret.txt")), "nothing");
}

TEST(SurroundingsTest, aRelativePathThatIsNotThereIsNotOutside) {
    LoadOptions options;
    Diagnostics diagnostics;
    Surroundings surroundings(options, diagnostics);
    surroundings.useFolder("");  // `walkcycle view hero.dae`: the folder is the working one
    EXPECT_EQ(read(surroundings, "no such picture.png"), "nothing");
    EXPECT_THAT(diagnostics.all(), IsEmpty());
}

TEST(SurroundingsTest, aLinkThatLeadsOutIsNoWayOut) {
    const TestFolder folder;
    folder.write("doc/a.txt", "inside");
    folder.write("secret.txt", "outside");
    std::filesystem::create_symlink(folder.path("secret.txt"), folder.path("doc/link.txt"));
    std::filesystem::create_directory_symlink(folder.path("."), folder.path("doc/up"));
    LoadOptions options;
    Diagnostics diagnostics;
    Surroundings surroundings(options, diagnostics);
    surroundings.useFolder(folder.path("doc"));
    EXPECT_EQ(read(surroundings, folder.path("doc/link.txt")), "nothing");
    EXPECT_EQ(read(surroundings, folder.path("doc/up/secret.txt")), "nothing");
    using namespace std::string_literals;
    EXPECT_EQ(read(surroundings, folder.path("secret.txt\0/../doc/a.txt"s)), "nothing");
}

TEST(SurroundingsTest, aDirectoryIsNoFile) {
    const TestFolder folder;
    folder.write("doc/maps/skin.png", "x");
    LoadOptions options;
    Diagnostics diagnostics;
    Surroundings surroundings(options, diagnostics);
    surroundings.useFolder(folder.path("doc"));
    EXPECT_EQ(read(surroundings, folder.path("doc/maps")), "nothing");
    EXPECT_EQ(read(surroundings, folder.path("doc/gone.png")), "nothing");
    EXPECT_THAT(surroundings.list(folder.path("doc/maps")), ElementsAre("skin.png"));
    EXPECT_THAT(surroundings.list(folder.path(".")), IsEmpty()) << "nor is a folder outside listed";
}

TEST(SurroundingsTest, aDocumentInMemoryHasNoFilesAroundIt) {
    const TestFolder folder;
    const std::string path = folder.write("a.txt", "x");
    LoadOptions options;
    Diagnostics diagnostics;
    Surroundings surroundings(options, diagnostics);
    EXPECT_EQ(read(surroundings, path), "nothing");
    EXPECT_THAT(surroundings.list(folder.path(".")), IsEmpty());
    EXPECT_THAT(diagnostics.all(), IsEmpty());
}

TEST(SurroundingsTest, theCallersResolverIsAskedInsteadOfTheDisk) {
    const TestFolder folder;
    const std::string path = folder.write("a.txt", "disk");
    LoadOptions options;
    options.resolver = [](const std::string& name) { return std::optional(bytesOf("resolved " + name)); };
    Diagnostics diagnostics;
    Surroundings surroundings(options, diagnostics);
    surroundings.useFolder(folder.path("."));
    EXPECT_EQ(read(surroundings, path), "resolved " + path);
    EXPECT_EQ(read(surroundings, "maps/../b.png"), "resolved b.png");
}

TEST(SurroundingsTest, membersOfAnArchiveAreItsFilesFolderByFolder) {
    LoadOptions options;
    Diagnostics diagnostics;
    Surroundings surroundings(options, diagnostics);
    surroundings.useArchive(Archive(zipOf({{"b.png", "b"}, {"maps/a.png", "a"}, {"a.dae", "x"}}), {}));
    EXPECT_EQ(read(surroundings, "maps/a.png"), "a");
    EXPECT_EQ(read(surroundings, "maps/../b.png"), "b");
    EXPECT_EQ(read(surroundings, "/etc/hostname"), "nothing");
    EXPECT_THAT(surroundings.list("."), ElementsAre("a.dae", "b.png"));
    EXPECT_THAT(surroundings.list("maps"), ElementsAre("a.png"));
}

}  // namespace
}  // namespace walkcycle
