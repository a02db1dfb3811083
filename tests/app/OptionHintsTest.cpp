#include <string>

#include <gmock/gmock.h>

#include "app/CodeNames.h"
#include "app/OptionHints.h"

namespace walkcycle {
namespace {

using ::testing::HasSubstr;

TEST(OptionHintsTest, everyHintIsForAMessageThatThereIs) {
    for (const OptionHint& hint : kOptionHints)
        EXPECT_NE(codeNamed(std::string(hint.code)), nullptr) << hint.code;
}

TEST(OptionHintsTest, theOptionStandsBehindTheCure) {
    EXPECT_EQ(withOption("WC0208", "move it there, or allow its folder"),
              "move it there, or allow its folder: --allow-path DIR");
    EXPECT_EQ(withOption("WC0801", "raise the limit 'scene-depth'"),
              "raise the limit 'scene-depth': --limit scene-depth=N");
    EXPECT_EQ(withOption("WC0101", "check the path"), "check the path");
    Diagnostic diagnostic;
    diagnostic.code = "WC0702";
    diagnostic.cure = "choose another scene";
    EXPECT_THAT(toString(withOption(diagnostic)), HasSubstr("(choose another scene: --scene ID)"));
}

}  // namespace
}  // namespace walkcycle
