#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "app/Faults.h"
#include "app/SmallDocuments.h"

namespace walkcycle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;

// What cannot be written is one line and exit code 2, and leaves the folder as it was.
class OutputFaultsTest : public testing::Test {
protected:
    OutputFaultsTest() {
        std::string text = liftedTriangle(), nodes;
        writeFile(document, bytesOf(text));
        for (int i = 0; i < 3000; ++i) nodes += "<node id=\"n" + std::to_string(i) + "\"/>";
        text.insert(text.find("<node id=\"front\">"), nodes);
        writeFile(large, bytesOf(text));
    }

    void expectRefused(const Ran& ran, const std::string& reason) {
        EXPECT_EQ(ran.exitCode, 2) << ran.err;
        EXPECT_THAT(ran.err, MatchesRegex("walkcycle: error: cannot write [^\n]+\n"));
        EXPECT_THAT(ran.err, HasSubstr(reason));
    }

    TestFolder source, output;
    std::string document = source / "lift.dae";
    std::string large = source / "large.dae";  // its pose fills a small disk
};

TEST_F(OutputFaultsTest, aFolderThatIsMissingClosedOrNoFolder) {
    expectRefused(runWalkcycle({"pose", document, "-o", output / "no/out.json"}), "No such file");
    expectRefused(runWalkcycle({"pose", document, "-o", document + "/out.json"}), "Not a directory");
    expectRefused(runWalkcycle({"pose", document, "-o", output.path()}), "it is a directory");
    ASSERT_EQ(::chmod(output.path().c_str(), 0555), 0);
    expectRefused(runWalkcycle({"pose", document, "-o", output / "out.json"}, "", {}, withoutPrivileges()),
                  "Permission denied");
    EXPECT_EQ(output.fileCount(), 0u);
}

TEST_F(OutputFaultsTest, aFileThatIsReadOnlyStays) {
    writeFile(output / "out.json", bytesOf("mine"));
    ASSERT_EQ(::chmod((output / "out.json").c_str(), 0444), 0);
    expectRefused(runWalkcycle({"pose", document, "-o", output / "out.json"}, "", {}, withoutPrivileges()),
                  "Permission denied");
    EXPECT_EQ(textOf(output / "out.json"), "mine");
    EXPECT_EQ(output.fileCount(), 1u);
}

// A disk of 64 KiB, where one may be mounted.
TEST_F(OutputFaultsTest, aFullDiskKeepsTheOldFileAndNothingElse) {
    const std::string mount = "mount -t tmpfs -o size=64k none '" + output.path() + "' && ";
    const std::string look =
        "; code=$?; ls -A '" + output.path() + "'; cat '" + (output / "out.json") + "'; exit $code";
    const Ran ran =
        runWalkcycle({"pose", large, "-o", output / "out.json"}, "", {},
                     {"/usr/bin/unshare", "-rm", "sh", "-c",
                      mount + "echo old > '" + (output / "out.json") + "' && \"$0\" \"$@\"" + look});
    if (ran.err.find("cannot write") == std::string::npos && ran.exitCode != 0)
        GTEST_SKIP() << "no file system may be mounted here: " << ran.err;
    expectRefused(ran, "No space left on device");
    EXPECT_EQ(ran.out, "out.json\nold\n");
}

TEST_F(OutputFaultsTest, aFileThatMayNotGrowFurtherIsAnErrorNotASignal) {
    const Ran ran = runWalkcycle({"pose", large, "-o", output / "out.json"}, "", {},
                                 {"/usr/bin/prlimit", "--fsize=10000"});
    expectRefused(ran, "File too large");
    EXPECT_EQ(output.fileCount(), 0u);
}

TEST_F(OutputFaultsTest, devicesThatAreFull) {
    expectRefused(runWalkcycle({"pose", document, "-o", "/dev/full"}), "No space left");
    expectRefused(runWalkcycle({"pose", document}, "", {}, shell("> /dev/full")),
                  "'standard output': No space");
}

TEST_F(OutputFaultsTest, standardOutputThatIsClosedOrHasNoReader) {
    const std::vector<std::vector<std::string>> commands = {
        {"pose", document}, {"info", document},  {"check", document}, {"explain", "WC0101"},
        {"--help"},         {"check", "--help"}, {"--version"}};
    for (const std::vector<std::string>& command : commands) {
        const std::string name = testing::PrintToString(command);
        const Ran closed = runWalkcycle(command, "", {}, shell(">&-"));
        EXPECT_EQ(closed.exitCode, 2) << name;
        EXPECT_THAT(closed.err, HasSubstr("cannot write 'standard output'")) << name;
        const Ran full = runWalkcycle(command, "", {}, shell("> /dev/full"));
        EXPECT_EQ(full.exitCode, 2) << name;
        const Ran broken = runWalkcycle(
            command, "", {},
            {"/bin/bash", "-c",
             "\"$0\" \"$@\" > >(exec true); wait $!; sleep 0.1; \"$0\" \"$@\" | :; exit ${PIPESTATUS[0]}"});
        EXPECT_TRUE(broken.exitCode == 2 || broken.exitCode == 0) << name << " must not end by SIGPIPE";
    }
}

// A file that takes the number of a closed standard stream must not get what is printed.
TEST_F(OutputFaultsTest, messagesNeverEndUpInTheOutputFile) {
    std::string text = liftedTriangle();
    text.replace(text.find("<p>0 1 2</p>"), 12, "<p>0 1 7</p>");
    writeFile(document, bytesOf(text));
    const Ran whole = runWalkcycle({"pose", document, "-o", output / "whole.json"});
    const Ran closed =
        runWalkcycle({"pose", document, "-o", output / "closed.json"}, "", {}, shell("<&- >&- 2>&-"));
    EXPECT_EQ(whole.exitCode, 0);
    EXPECT_EQ(closed.exitCode, 0);
    EXPECT_EQ(textOf(output / "closed.json"), textOf(output / "whole.json"));
    EXPECT_EQ(textOf(document), text);
}

struct Interruption {
    std::string signal, call;
    int exitCode;
};

// Whatever ends the program at whichever step of writing, the file is the old one or the new one.
TEST_F(OutputFaultsTest, aSignalWhileWritingLeavesTheOldFileOrTheNewOne) {
    if (!canTrace()) GTEST_SKIP() << "strace is not installed, or may not trace";
    ASSERT_EQ(runWalkcycle({"pose", document, "-o", source / "new.json"}).exitCode, 0);
    const std::string fresh = textOf(source / "new.json");
    for (const Interruption& by : {Interruption{"INT", "write", 130}, Interruption{"TERM", "write", 143},
                                   Interruption{"KILL", "write", 137}, Interruption{"INT", "/rename", 130},
                                   Interruption{"TERM", "/rename", 143}, Interruption{"KILL", "/rename", 137},
                                   Interruption{"HUP", "fchmod", 129}}) {
        SCOPED_TRACE(by.signal + " at " + by.call);
        const TestFolder here;
        writeFile(here / "out.json", bytesOf("old"));
        const auto interrupted = strace(
            source / "log",
            {"-e", "trace=" + by.call, "-e", "inject=" + by.call + ":signal=" + by.signal + ":when=1"});
        const Ran ran = runWalkcycle({"pose", document, "-o", here / "out.json"}, "", traced(), interrupted);
        EXPECT_EQ(ran.exitCode, by.exitCode);
        const std::string left = textOf(here / "out.json");
        EXPECT_TRUE(left == "old" || left == fresh) << left.substr(0, 100);
        EXPECT_TRUE(by.signal == "KILL" || here.fileCount() == 1) << "a temporary file is left";
    }
}

TEST_F(OutputFaultsTest, whatFailsWhileWritingLeavesTheOldFile) {
#ifdef WALKCYCLE_ADDRESS_SANITIZER
    GTEST_SKIP() << "the sanitizer writes, too, and does not survive that it fails";
#endif
    if (!canTrace()) GTEST_SKIP() << "strace is not installed, or may not trace";
    for (const auto& [call, error, reason] :
         {std::tuple("write", "ENOSPC", "No space left"), std::tuple("write", "EIO", "Input/output error"),
          std::tuple("/rename", "EACCES", "Permission denied"),
          std::tuple("fchmod", "EPERM", "not permitted")}) {
        SCOPED_TRACE(call);
        const TestFolder here;
        writeFile(here / "out.json", bytesOf("old"));
        const auto failing =
            strace(source / "log", {"-e", std::string("trace=") + call, "-e",
                                    std::string("inject=") + call + ":error=" + error + ":when=1"});
        const Ran ran = runWalkcycle({"pose", document, "-o", here / "out.json"}, "", traced(), failing);
        expectRefused(ran, reason);
        EXPECT_EQ(textOf(here / "out.json"), "old");
        EXPECT_EQ(here.fileCount(), 1u);
    }
}

// After SIGKILL a temporary file stays, and must not be in the way of the next program of that number.
TEST_F(OutputFaultsTest, aTemporaryFileThatWasLeftBehindIsNotInTheWay) {
    const std::string plant =
        "for n in 0 1 2; do echo x > '" + output.path() + "'/.walkcycle-$$-$n.tmp; done; exec \"$0\" \"$@\"";
    const Ran ran =
        runWalkcycle({"pose", document, "-o", output / "out.json"}, "", {}, {"/bin/sh", "-c", plant});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(output.fileCount(), 4u);
}

}  // namespace
}  // namespace walkcycle
