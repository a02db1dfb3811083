#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "RunProgram.h"
#include "loaders/quirks/Quirks.h"

namespace walkcycle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kSkin = WALKCYCLE_FIXTURES "/quirks/skin-by-node.dae";
const std::string kHidden = WALKCYCLE_FIXTURES "/quirks/extra-visibility.dae";

TEST(QuirkOptionTest, infoVerboseListsTheDialectAndEveryQuirkWithItsReason) {
    const Ran ran = runWalkcycle({"info", kSkin, "--verbose", "--quirk", "spaced-names=off"});
    EXPECT_THAT(ran.out, AllOf(HasSubstr("dialect    ColladaMaya 3.3\n"),
                               HasSubstr("skin-by-node: on, for ColladaMaya, Softimage; used in this file\n"),
                               HasSubstr("inverted-transparency: off, only for SketchUp before 7.1\n"),
                               HasSubstr("zero-transparency: on, where the file shows it\n"),
                               HasSubstr("spaced-names: off, as chosen\n")));
    for (const QuirkInfo& quirk : kQuirks)
        EXPECT_THAT(ran.out, HasSubstr(" " + std::string(quirk.name) + ": ")) << quirk.name;
    EXPECT_THAT(ran.err, HasSubstr("WC0406"));
    EXPECT_THAT(runWalkcycle({"info", kSkin}).out, Not(HasSubstr("skin-by-node:")));
}

TEST(QuirkOptionTest, infoJsonHasThemToo) {
    EXPECT_THAT(runWalkcycle({"info", kSkin, "--json"}).out,
                AllOf(HasSubstr("\"dialect\": \"ColladaMaya 3.3\""), HasSubstr("\"name\": \"skin-by-node\""),
                      HasSubstr("\"why\": \"for ColladaMaya, Softimage\"")));
    EXPECT_THAT(runWalkcycle({"info", kHidden, "--json"}).out, HasSubstr("\"dialect\": \"\""));
}

TEST(QuirkOptionTest, aQuirkIsSwitchedOnEveryVerbThatReadsAFile) {
    const std::string y5 = "\"positions\":[[0,5,0,1,5,0,0,6,0]]", y0 = "\"positions\":[[0,0,0,1,0,0,0,1,0]]";
    const auto posed = [](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"pose", kSkin};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return runWalkcycle(arguments).out;
    };
    EXPECT_THAT(posed({}), HasSubstr(y5));
    EXPECT_THAT(posed({"--quirk", "skin-by-node=off"}), HasSubstr(y0));
    EXPECT_THAT(posed({"--quirk=skin-by-node=off", "--quirk=skin-by-node=on"}), HasSubstr(y5));
    EXPECT_THAT(posed({"--skin-node", "ignore"}), HasSubstr(y0));
    EXPECT_THAT(posed({"--skin-node", "apply"}), HasSubstr(y5));
    EXPECT_THAT(runWalkcycle({"check", kHidden}).err + runWalkcycle({"check", kHidden}).out,
                HasSubstr("(quirk extra-visibility)"));
    for (const char* verb : {"view", "render", "info", "check", "pose"})
        EXPECT_THAT(runWalkcycle({verb, "--help"}).out, HasSubstr("--quirk NAME=on|off")) << verb;
}

TEST(QuirkOptionTest, aWrongNameOrChoiceIsRefusedAndTheNearestNameGiven) {
    const Ran unknown = runWalkcycle({"info", kSkin, "--quirk", "skin-by-nod=on"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.err,
                AllOf(HasSubstr("there is no quirk 'skin-by-nod'; perhaps 'skin-by-node' is meant"),
                      HasSubstr("texture-names-image")));
    for (const char* wrong : {"skin-by-node", "skin-by-node=", "skin-by-node=auto", "=on", ""}) {
        const Ran ran = runWalkcycle({"info", kSkin, "--quirk", wrong});
        EXPECT_EQ(ran.exitCode, 2) << wrong;
        EXPECT_THAT(ran.err, HasSubstr("--quirk")) << wrong;
    }
}

}  // namespace
}  // namespace walkcycle
