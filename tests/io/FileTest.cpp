#include <cstdint>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/TestFolder.h"
#include "walkcycle/io/File.h"

namespace walkcycle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::uint64_t kPlenty = 1000;

TEST(FileTest, whatIsWrittenIsReadBack) {
    const TestFolder folder;
    writeFile(folder / "walk.dae", bytesOf("<COLLADA/>"));
    EXPECT_EQ(readFile(folder / "walk.dae", kPlenty), bytesOf("<COLLADA/>"));
    EXPECT_EQ(folder.fileCount(), 1u) << "no temporary file stays";
}

TEST(FileTest, anEmptyFileIsReadAsNoBytes) {
    const TestFolder folder;
    writeFile(folder / "empty", {});
    EXPECT_TRUE(readFile(folder / "empty", kPlenty).empty());
}

TEST(FileTest, namesInAnyLanguageWork) {
    const TestFolder folder;
    writeFile(folder / "Läufer 歩く.dae", bytesOf("x"));
    EXPECT_EQ(readFile(folder / "Läufer 歩く.dae", kPlenty).size(), 1u);
}

TEST(FileTest, aMissingFileIsNamedWithTheReason) {
    EXPECT_THAT([] { readFile("/nowhere/walk.dae", kPlenty); },
                ThrowsMessage<FileError>(AllOf(HasSubstr("/nowhere/walk.dae"), HasSubstr("No such file"))));
}

TEST(FileTest, aDirectoryIsNoFile) {
    const TestFolder folder;
    EXPECT_THAT([&] { readFile(folder.path(), kPlenty); }, ThrowsMessage<FileError>(HasSubstr("directory")));
    EXPECT_THAT([&] { writeFile(folder.path(), {}); }, ThrowsMessage<FileError>(HasSubstr("directory")));
}

TEST(FileTest, aPipeIsRefusedAtOnceInsteadOfWaitedFor) {
    const TestFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_THAT([&] { readFile(folder / "pipe", kPlenty); }, ThrowsMessage<FileError>(HasSubstr("pipe")));
    EXPECT_THROW(writeFile(folder / "pipe", bytesOf("x")), FileError) << "nobody reads it";
}

TEST(FileTest, aDeviceIsRefusedForReading) {
    EXPECT_THAT([] { readFile("/dev/zero", kPlenty); }, ThrowsMessage<FileError>(HasSubstr("device")));
}

TEST(FileTest, aFileOverTheLimitIsRefusedAndOneAtTheLimitIsNot) {
    const TestFolder folder;
    writeFile(folder / "ten", bytesOf("0123456789"));
    EXPECT_EQ(readFile(folder / "ten", 11).size(), 10u);
    EXPECT_EQ(readFile(folder / "ten", 10).size(), 10u);
    EXPECT_THAT([&] { readFile(folder / "ten", 9); }, ThrowsMessage<FileError>(HasSubstr("limit of 9")));
}

TEST(FileTest, aNameWithAZeroByteOpensNothing) {
    const TestFolder folder;
    writeFile(folder / "secret", bytesOf("x"));
    EXPECT_THROW(readFile((folder / "secret") + std::string("\0.dae", 5), kPlenty), FileError);
    EXPECT_THROW(readFile("", kPlenty), FileError);
}

TEST(FileTest, writingIntoAMissingFolderFailsWithTheReason) {
    EXPECT_THAT([] { writeFile("/nowhere/out.png", {}); },
                ThrowsMessage<FileError>(HasSubstr("No such file")));
}

TEST(FileTest, aFullDiskIsReported) {
    EXPECT_THAT([] { writeFile("/dev/full", bytesOf("x")); },
                ThrowsMessage<FileError>(HasSubstr("No space left")));
}

TEST(FileTest, devicesAreWrittenToAndStay) {
    writeFile("/dev/null", bytesOf("x"));
    struct stat status {};
    ASSERT_EQ(::stat("/dev/null", &status), 0);
    EXPECT_TRUE(S_ISCHR(status.st_mode));
}

TEST(FileTest, aLinkStaysALinkAndItsTargetIsWritten) {
    const TestFolder folder;
    writeFile(folder / "target", bytesOf("old"));
    ASSERT_EQ(::symlink("target", (folder / "link").c_str()), 0);
    writeFile(folder / "link", bytesOf("new"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(readFile(folder / "target", kPlenty), bytesOf("new"));
}

TEST(FileTest, permissionsOfAReplacedFileStay) {
    const TestFolder folder;
    writeFile(folder / "out", bytesOf("old"));
    ASSERT_EQ(::chmod((folder / "out").c_str(), 0640), 0);
    writeFile(folder / "out", bytesOf("new"));
    struct stat status {};
    ASSERT_EQ(::stat((folder / "out").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(FileTest, theLongestNamePossibleCanBeWritten) {
    const TestFolder folder;
    writeFile(folder / std::string(255, 'x'), bytesOf("x"));
    EXPECT_EQ(folder.fileCount(), 1u);
}

}  // namespace
}  // namespace walkcycle
