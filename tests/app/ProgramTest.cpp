#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/Commands.h"
#include "app/RunProgram.h"
#include "app/SmallDocuments.h"
#include "io/TestFolder.h"

namespace walkcycle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

class ProgramTest : public testing::Test {
protected:
    std::string file(const std::string& name, const std::string& text) {
        writeFile(folder / name, bytesOf(text));
        return folder / name;
    }
    TestFolder folder;
};

TEST_F(ProgramTest, helpGoesToStandardOutputForTheProgramAndEachVerb) {
    const Ran all = runWalkcycle({"--help"});
    EXPECT_EQ(all.exitCode, 0);
    EXPECT_THAT(all.out, AllOf(HasSubstr("Examples:"), HasSubstr("render"), HasSubstr("Exit codes")));
    for (const Command& verb : allCommands()) {
        EXPECT_THAT(all.out, HasSubstr(verb.name));
        const Ran one = runWalkcycle({verb.name, "--help"});
        EXPECT_EQ(one.exitCode, 0) << verb.name;
        EXPECT_THAT(one.out, HasSubstr("Examples:")) << verb.name;
        EXPECT_THAT(one.err, IsEmpty()) << verb.name;
    }
}

TEST_F(ProgramTest, versionNamesTheLibrariesAndTheOpenGl) {
    const Ran ran = runWalkcycle({"--version"});
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_THAT(ran.out, AllOf(StartsWith("walkcycle "), HasSubstr("tinyxml2 9"), HasSubstr("zlib 1"),
                               HasSubstr("OpenGL")));
}

TEST_F(ProgramTest, wrongUsageExitsWithTwoAndOneLine) {
    const std::string good = file("good.dae", liftedTriangle());
    const std::vector<std::vector<std::string>> wrong = {
        {"--frobnicate"},
        {"rendre"},
        {"render"},
        {"render", good},
        {"render", good, "-o", "x.gif"},
        {"render", good, "-o", "x.png", "--resolution", "0,10"},
        {"render", good, "-o", "x.png", "--time", "soon"},
        {"render", good, "-o", "x.png", "--background", "blue"},
        {"render", good, "-o", "x_{frame:zz}.png"},
        {"render", good, "-o", "x.png", "--lights", "disco"},
        {"view", good, "--speed", "1000"},
        {"view", good, "--speed", "-0.001"},
        {"pose", good, "--time", "nan"},
        {"pose", good, "--up", "W"},
        {"check"},
        {"explain", "WC9999"},
        {"compare", good}};
    for (const std::vector<std::string>& arguments : wrong) {
        const Ran ran = runWalkcycle(arguments);
        EXPECT_EQ(ran.exitCode, 2) << testing::PrintToString(arguments);
        EXPECT_THAT(ran.out, IsEmpty()) << testing::PrintToString(arguments);
        EXPECT_THAT(ran.err, MatchesRegex("walkcycle: error: [^\n]+\n")) << testing::PrintToString(arguments);
    }
}

TEST_F(ProgramTest, aMisspeltVerbOrOptionNamesTheNearestOne) {
    const std::string good = file("good.dae", liftedTriangle());
    EXPECT_THAT(runWalkcycle({"rendre"}).err, AllOf(HasSubstr("perhaps 'render'"), HasSubstr("compare")));
    EXPECT_THAT(runWalkcycle({"pose", good, "--tiem", "1"}).err, HasSubstr("perhaps '--time'"));
    EXPECT_THAT(runWalkcycle({"pose", "--exakt=1", good}).err, HasSubstr("perhaps '--exact'"));
    EXPECT_THAT(runWalkcycle({good, "--wireframes"}).err, HasSubstr("perhaps '--wireframe'"));
    EXPECT_THAT(runWalkcycle({"pose", good, "--frobnicate"}).err, Not(HasSubstr("perhaps")));
    EXPECT_THAT(runWalkcycle({"--versoin"}).err, HasSubstr("perhaps '--version'"));
    EXPECT_THAT(runWalkcycle({"info", "--version"}).err, Not(HasSubstr("perhaps")));
    EXPECT_THAT(runWalkcycle({good, "--loop", "Once"}).err, HasSubstr("perhaps 'once'"));
}

TEST_F(ProgramTest, wrongArgumentsAreAnsweredInPlainWords) {
    const std::string good = file("good.dae", liftedTriangle());
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrongAndAnswer = {
        {{"pose", good, "--frobnicate", "3"}, "pose has no option '--frobnicate' (walkcycle pose --help"},
        {{"info", good, "-x"}, "info has no option '-x' (walkcycle info --help"},
        {{"info", good, "b", "c"}, "info does not take 'b', 'c' as well"},
        {{"pose", good, "--time"}, "--time needs a value"},
        {{"info", good, "--unit", "1", "--unit", "2"}, "--unit can be given once only"},
        {{"view", good, "--loop", "twice"}, "--loop: 'twice' is none of once, loop, pingpong"},
        {{"info", good, "--limit", "nesting"}, "--limit: 'nesting' has no value, as in nesting=98"}};
    for (const auto& [arguments, answer] : wrongAndAnswer)
        EXPECT_THAT(runWalkcycle(arguments).err, HasSubstr("walkcycle: error: " + answer));
}

TEST_F(ProgramTest, aFileThatCannotBeReadExitsWithTwoAndItsName) {
    ASSERT_EQ(::system(("mkfifo '" + (folder / "pipe") + "'").c_str()), 0);
    for (const std::string& name : {folder / "missing.dae", folder / "pipe", std::string("/dev/zero")})
        for (const char* verb : {"info", "check", "pose"}) {
            const Ran ran = runWalkcycle({verb, name});
            EXPECT_EQ(ran.exitCode, 2) << verb << " " << name;
            EXPECT_THAT(ran.err, AllOf(HasSubstr(name), HasSubstr("WC0101"))) << verb;
        }
    EXPECT_EQ(runWalkcycle({"pose", folder.path()}).exitCode, 2) << "a folder";
}

TEST_F(ProgramTest, whatIsNoColladaExitsWithOneAndACodedLine) {
    for (const std::string& text :
         {std::string(), std::string("hello"), std::string("<html/>"), std::string("<COLLADA")}) {
        const std::string name = file("bad.dae", text);
        for (const char* verb : {"info", "check", "pose"}) {
            const Ran ran = runWalkcycle({verb, name});
            EXPECT_EQ(ran.exitCode, 1) << verb << " '" << text << "'";
            EXPECT_THAT(ran.err, AllOf(HasSubstr(name), HasSubstr(": error WC01")));
        }
    }
}

TEST_F(ProgramTest, checkSaysThatAGoodFileIsFine) {
    const std::string name = file("good.dae", liftedTriangle());
    const Ran ran = runWalkcycle({"check", name});
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_EQ(ran.out, name + ": fine\n");
    EXPECT_THAT(ran.err, IsEmpty());
}

TEST_F(ProgramTest, checkNamesTheLineOfAnErrorAndExitsWithOne) {
    const std::string name = file("bad.dae", damagedTriangle());
    const Ran ran = runWalkcycle({"check", name});
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_THAT(ran.err, HasSubstr(name + ":12: error WC0301"));
    EXPECT_THAT(ran.out, HasSubstr("1 error"));
}

TEST_F(ProgramTest, warningsFailOnlyWhereAskedTo) {
    const std::string name = file("unpainted.dae", unpaintedTriangle());
    const Ran ran = runWalkcycle({"check", name});
    EXPECT_EQ(ran.exitCode, 0);
    ASSERT_THAT(ran.err, HasSubstr(": warning WC0"));
    const std::string code = ran.err.substr(ran.err.find("WC0"), 6);
    EXPECT_EQ(runWalkcycle({"check", name, "--strict"}).exitCode, 1);
    EXPECT_EQ(runWalkcycle({"check", name, "--fail-on=warning"}).exitCode, 1);
    EXPECT_EQ(runWalkcycle({"pose", name, "--strict"}).exitCode, 1);
    EXPECT_EQ(runWalkcycle({"pose", name}).exitCode, 0);
    const Ran ignored = runWalkcycle({"check", name, "--strict", "--ignore", code});
    EXPECT_EQ(ignored.exitCode, 0) << ignored.err;
}

TEST_F(ProgramTest, checkGoesThroughAFolder) {
    file("a.dae", liftedTriangle());
    file("b.DAE", damagedTriangle());
    file("notes.txt", "no document");
    const Ran ran = runWalkcycle({"check", folder.path()});
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_THAT(ran.out,
                AllOf(HasSubstr("a.dae: fine"), HasSubstr("b.DAE: 1 error"), Not(HasSubstr("notes.txt"))));
    const TestFolder empty;
    EXPECT_EQ(runWalkcycle({"check", empty.path()}).exitCode, 2);
}

TEST_F(ProgramTest, checkPrintsJsonInTheValidatorsShape) {
    const std::string name = file("bad.dae", damagedTriangle());
    const Ran one = runWalkcycle({"check", name, "--json"});
    EXPECT_EQ(one.exitCode, 1);
    EXPECT_THAT(one.err, IsEmpty());
    for (const char* field :
         {"\"uri\"", "\"validatorVersion\"", "\"numErrors\": 1", "\"numWarnings\"", "\"numInfos\"",
          "\"code\": \"WC0301\"", "\"severity\": 0", "\"pointer\"", "\"line\": 12", "\"truncated\": false"})
        EXPECT_THAT(one.out, HasSubstr(field));
    EXPECT_THAT(runWalkcycle({"check", name, name, "--json"}).out, StartsWith("["));
}

TEST_F(ProgramTest, aDocumentMayComeFromStandardInput) {
    const Ran ran = runWalkcycle({"info", "-"}, liftedTriangle());
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("1 triangle"));
}

TEST_F(ProgramTest, infoTellsWhatIsThereAsTextAndAsJson) {
    const std::string name = file("lift.dae", liftedTriangle());
    const Ran text = runWalkcycle({"info", name});
    EXPECT_THAT(text.out,
                AllOf(HasSubstr("Y up"), HasSubstr("'up'"), HasSubstr("'triangle'"), HasSubstr("'front'")));
    const Ran json = runWalkcycle({"info", name, "--json"});
    EXPECT_THAT(json.out, AllOf(HasSubstr("\"upAxis\": \"Y\""), HasSubstr("\"name\": \"down\""),
                                HasSubstr("\"triangles\": 1")));
}

TEST_F(ProgramTest, errorsDoNotKeepAPoseFromBeingGiven) {
    const Ran ran = runWalkcycle({"pose", file("bad.dae", damagedTriangle())});
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_THAT(ran.err, HasSubstr("WC0301"));
    EXPECT_THAT(runWalkcycle({"pose", folder / "bad.dae", "--quiet"}).err, IsEmpty());
}

TEST_F(ProgramTest, poseIsOnTheDocumentsTimelineUnlessAClipIsNamed) {
    const std::string name = file("lift.dae", liftedTriangle());
    const std::string atOneAndAHalf = "\"positions\":[[0,1,0,1,1,0,0,2,0]]";
    EXPECT_THAT(runWalkcycle({"pose", name, "--time", "1.5"}).out, HasSubstr(atOneAndAHalf));
    EXPECT_THAT(runWalkcycle({"pose", name, "--time=0.5", "--clip=down"}).out, HasSubstr(atOneAndAHalf));
    EXPECT_THAT(runWalkcycle({"pose", name, "--time", "1.5", "--exact"}).out, HasSubstr(atOneAndAHalf));
    EXPECT_THAT(runWalkcycle({"pose", name, "--time", "-3,99"}).out,
                HasSubstr("\"positions\":[[0,0,0,1,0,0,0,1,0],[0,0,0,1,0,0,0,1,0]]"));
    const Ran unknown = runWalkcycle({"pose", name, "--clip", "sideways"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.err, AllOf(HasSubstr("'sideways'"), HasSubstr("'down'")));
}

TEST_F(ProgramTest, poseNamesJointsWithTheirMatricesRowByRow) {
    const Ran ran = runWalkcycle({"pose", file("lift.dae", liftedTriangle()), "--time", "1", "--json"});
    EXPECT_THAT(ran.out,
                HasSubstr(R"("lift":{"name":"Lift","sid":"","world":[[1,0,0,0,0,1,0,2,0,0,1,0,0,0,0,1]]})"));
    EXPECT_THAT(ran.out, HasSubstr(R"("node":"lift","geometry":"triangle","source":"#triangle")"));
}

TEST_F(ProgramTest, poseWritesAnObj) {
    const std::string name = file("lift.dae", liftedTriangle());
    EXPECT_EQ(runWalkcycle({"pose", name, "--time", "1", "-o", folder / "out.obj"}).exitCode, 0);
    const Bytes obj = readFile(folder / "out.obj", 1 << 20);
    EXPECT_THAT(std::string(obj.begin(), obj.end()), AllOf(HasSubstr("v 0 2 0\n"), HasSubstr("f ")));
    EXPECT_EQ(runWalkcycle({"pose", name, "--time", "0,1", "-o", folder / "two.obj"}).exitCode, 2);
}

TEST_F(ProgramTest, outputThatCannotBeWrittenExitsWithTwoAndLeavesNothing) {
    const std::string name = file("lift.dae", liftedTriangle());
    for (const std::string& output :
         {folder / "no/such/folder.json", name + "/out.json", std::string("/dev/full")}) {
        const Ran ran = runWalkcycle({"pose", name, "-o", output});
        EXPECT_EQ(ran.exitCode, 2) << output;
        EXPECT_THAT(ran.err, HasSubstr("cannot write '" + output)) << output;
    }
    EXPECT_EQ(folder.fileCount(), 1u) << "only the document itself";
}

// Root may write everywhere, so it runs the program as somebody else.
TEST_F(ProgramTest, aFolderThatIsReadOnlyStaysAsItIs) {
    const std::string name = file("lift.dae", liftedTriangle());
    const TestFolder closed;
    ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
    ASSERT_EQ(::chmod(closed.path().c_str(), 0555), 0);
    std::vector<std::string> asNobody;
    if (::geteuid() == 0) asNobody = {"/usr/bin/setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"};
    const Ran ran = runWalkcycle({"pose", name, "-o", closed / "out.json"}, "", {}, asNobody);
    if (ran.exitCode == 126 || ran.exitCode == 127)
        GTEST_SKIP() << "nobody may not run it from here: " << ran.err;
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("Permission denied"));
    EXPECT_EQ(closed.fileCount(), 0u);
}

TEST_F(ProgramTest, explainTellsCauseAndCure) {
    for (const char* code : {"WC0301", "wc0301", "301"}) {
        const Ran ran = runWalkcycle({"explain", code});
        EXPECT_EQ(ran.exitCode, 0);
        EXPECT_THAT(ran.out, AllOf(HasSubstr("WC0301"), HasSubstr("means:"), HasSubstr("cure:")));
    }
}

TEST_F(ProgramTest, explainSaysWordsWhereMessagesTakeTheirsFromTheFile) {
    EXPECT_THAT(runWalkcycle({"explain", "WC0207"}).out,
                HasSubstr("says:  <ELEMENT> refers to 'URI', which is a <FOUND>, not a <EXPECTED>\n"));
    EXPECT_THAT(runWalkcycle({"explain", "801"}).out, HasSubstr("--limit NAME=N"));
    const Ran all = runWalkcycle({"explain"});
    EXPECT_THAT(all.out, AllOf(HasSubstr("WC0402"), Not(HasSubstr("{")), Not(HasSubstr("}"))));
}

TEST_F(ProgramTest, checkAndPoseNeedNoGraphics) {
    const std::string name = file("lift.dae", liftedTriangle());
    const std::map<std::string, std::string> nothing = {
        {"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}};
    EXPECT_EQ(runWalkcycle({"check", name}, "", nothing).exitCode, 0);
    EXPECT_EQ(runWalkcycle({"pose", name}, "", nothing).exitCode, 0);
    const Ran render = runWalkcycle({"render", name, "-o", folder / "out.png"}, "", nothing);
    EXPECT_EQ(render.exitCode, 3);
    EXPECT_THAT(render.err, MatchesRegex("walkcycle: error: [^\n]+\n"));
    EXPECT_EQ(folder.fileCount(), 1u);
    const Ran view = runWalkcycle({name}, "", nothing);
    EXPECT_EQ(view.exitCode, 3);
    EXPECT_THAT(view.err, AllOf(MatchesRegex("walkcycle: error: [^\n]+\n"), HasSubstr("walkcycle render")));
}

}  // namespace
}  // namespace walkcycle
