#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "app/Faults.h"
#include "app/SmallDocuments.h"

namespace walkcycle {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class DocumentFaultsTest : public testing::Test {
protected:
    std::string file(const std::string& name, const std::string& text) {
        writeFile(folder / name, bytesOf(text));
        return folder / name;
    }
    TestFolder folder, output;
};

// Every verb says the same of a document that it cannot have: one line, with its code.
TEST_F(DocumentFaultsTest, aDocumentThatCannotBeHadIsOneLineAndAnExitCode) {
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    ASSERT_EQ(::symlink("loop", (folder / "loop").c_str()), 0);
    const std::string closed = file("closed.dae", liftedTriangle());
    ASSERT_EQ(::chmod(closed.c_str(), 0), 0);
    struct Case {
        std::string name, says;
        int exitCode;
    };
    for (const Case& fault :
         {Case{folder / "missing.dae", "WC0101: cannot read '", 2}, Case{closed, "Permission denied", 2},
          Case{folder / "pipe", "it is a pipe", 2},
          Case{folder / "loop", "Too many levels of symbolic links", 2},
          Case{file("empty.dae", ""), "WC0102: not well-formed XML: the file is empty", 1}})
        for (const std::string verb : {"view", "render", "info", "check", "pose"}) {
            std::vector<std::string> arguments = {verb, fault.name};
            if (verb == "render") arguments.insert(arguments.end(), {"-o", output / "out.png"});
            const Ran ran = runWalkcycle(arguments, "", {}, withoutPrivileges());
            EXPECT_EQ(ran.exitCode, fault.exitCode) << verb << ": " << ran.err;
            EXPECT_THAT(ran.err, HasSubstr(fault.says)) << verb;
            EXPECT_EQ(linesOf(ran.err), 1) << verb << ": " << ran.err;
        }
    EXPECT_EQ(output.fileCount(), 0u);
}

TEST_F(DocumentFaultsTest, aFolderIsNoDocument) {
    for (const char* verb : {"view", "info", "pose"}) {
        const Ran ran = runWalkcycle({verb, folder.path()});
        EXPECT_EQ(ran.exitCode, 2) << verb;
        EXPECT_THAT(ran.err, HasSubstr("it is a directory"));
        EXPECT_EQ(linesOf(ran.err), 1) << ran.err;
    }
}

TEST_F(DocumentFaultsTest, memoryThatRunsOutIsOneLine) {
    std::string numbers;
    for (int i = 0; i < 8'000'000; ++i) numbers += "1.5 ";
    std::string text = liftedTriangle();
    text.replace(text.find("0 0 0 1 0 0"), 1, numbers);
    const Ran ran = runWalkcycle({"info", file("large.dae", text)}, "", {},
                                 {"/usr/bin/prlimit", "--as=" + std::to_string(80 << 20)});
    if (ran.err.find("AddressSanitizer") != std::string::npos) GTEST_SKIP() << "the sanitizer needs more";
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_EQ(ran.err, "walkcycle: error: there is not enough memory\n");
}

TEST_F(DocumentFaultsTest, littleMemoryIsEnoughForLittle) {
#ifdef WALKCYCLE_ADDRESS_SANITIZER
    GTEST_SKIP() << "the sanitizer needs more";
#endif
    const std::string name = file("lift.dae", liftedTriangle());
    for (const char* limit : {"--data=20971520", "--as=62914560"})
        EXPECT_EQ(runWalkcycle({"info", name}, "", {}, {"/usr/bin/prlimit", limit}).exitCode, 0) << limit;
}

TEST_F(DocumentFaultsTest, limitsAreRaisedAndLoweredByName) {
    const std::string name = file("lift.dae", liftedTriangle());
    const Ran few = runWalkcycle({"info", name, "--limit", "elements=20", "--limit=file-bytes=2G"});
    EXPECT_EQ(few.exitCode, 1);
    EXPECT_THAT(few.err,
                AllOf(HasSubstr("WC0801: 21 XML elements of a document are over the limit elements=20"),
                      HasSubstr("--limit elements=N")));
    EXPECT_EQ(runWalkcycle({"info", name, "--limit", "elements=1k"}).exitCode, 0);
    EXPECT_EQ(runWalkcycle({"check", "--limit", "elements=20", "--limit", "elements=1M", name}).exitCode, 0);
    EXPECT_EQ(runWalkcycle({"info", name, "--limit", "file-bytes=99"}).exitCode, 1);
    const Ran unknown = runWalkcycle({"info", name, "--limit", "bones=4"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.err,
                AllOf(HasSubstr("'bones' is not a limit"), HasSubstr("file-bytes, elements, nesting")));
    for (const char* wrong : {"elements", "elements=", "elements=many", "elements=-1", "nesting=99", "=5"})
        EXPECT_EQ(runWalkcycle({"info", name, "--limit", wrong}).exitCode, 2) << wrong;
    EXPECT_THAT(runWalkcycle({"check", "--help"}).out, HasSubstr("--limit NAME=VALUE"));
}

// A pipe hands out what its writer has just put in; here, a byte at a time.
TEST_F(DocumentFaultsTest, aDocumentThatComesByteByByteIsTheSame) {
    const std::string name = file("lift.dae", liftedTriangle()), pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] {
        const int fd = ::open(pipe.c_str(), O_WRONLY);
        for (const char c : liftedTriangle()) {
            if (::write(fd, &c, 1) != 1) break;
            std::this_thread::sleep_for(std::chrono::microseconds(20));
        }
        ::close(fd);
    });
    const Ran whole = runWalkcycle({"pose", "-", "--time", "0.5"}, liftedTriangle());
    const Ran slow = runWalkcycle({"pose", "-", "--time", "0.5"}, "", {}, shell("< '" + pipe + "'"));
    writer.join();
    EXPECT_EQ(slow.exitCode, 0) << slow.err;
    EXPECT_EQ(slow.out, whole.out);
}

TEST_F(DocumentFaultsTest, aReadThatASignalInterruptsGoesOn) {
    if (!canTrace()) GTEST_SKIP() << "strace is not installed, or may not trace";
    const std::string name = file("lift.dae", liftedTriangle());
    const auto interrupted = strace(folder / "log", {"-P", name, "-e", "inject=read:error=EINTR:when=1..5"});
    const Ran ran = runWalkcycle({"pose", name}, "", traced(), interrupted);
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(ran.out, runWalkcycle({"pose", name}).out);
    EXPECT_THAT(textOf(folder / "log"), HasSubstr("EINTR"));
}

TEST_F(DocumentFaultsTest, aReadErrorIsOneLine) {
    if (!canTrace()) GTEST_SKIP() << "strace is not installed, or may not trace";
    const std::string name = file("lift.dae", liftedTriangle());
    const auto broken = strace(folder / "log", {"-P", name, "-e", "inject=read:error=EIO"});
    const Ran ran = runWalkcycle({"pose", name}, "", traced(), broken);
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("Input/output error"));
    EXPECT_EQ(linesOf(ran.err), 1) << ran.err;
}

// The first read waits two seconds, in which somebody else writes into the file.
TEST_F(DocumentFaultsTest, aFileThatChangesWhileItIsReadIsAClearError) {
    if (!canTrace()) GTEST_SKIP() << "strace is not installed, or may not trace";
    for (const std::string change : {"shrink", "grow", "rewrite"}) {
        const std::string name = file("lift.dae", liftedTriangle()), log = folder / "log";
        std::filesystem::remove(log);
        std::thread other([&] {
            for (int i = 0; i < 600; ++i) {
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
                if (std::filesystem::exists(log) && textOf(log).find("lift.dae") != std::string::npos) break;
            }
            const int fd = ::open(name.c_str(), O_WRONLY | (change == "grow" ? O_APPEND : 0));
            EXPECT_TRUE(change == "shrink" ? ::ftruncate(fd, 1000) == 0 : ::write(fd, "<!---->", 7) == 7);
            ::close(fd);
        });
        const auto slow = strace(
            log, {"-P", name, "-e", "trace=openat,read", "-e", "inject=read:delay_enter=2000000:when=1"});
        const Ran ran = runWalkcycle({"pose", name}, "", traced(), slow);
        other.join();
        EXPECT_EQ(ran.exitCode, 2) << change;
        EXPECT_THAT(ran.err, HasSubstr("it changed while it was being read")) << change;
    }
}

}  // namespace
}  // namespace walkcycle
