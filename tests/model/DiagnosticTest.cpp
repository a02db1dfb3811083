#include <gtest/gtest.h>

#include "model/Diagnostic.h"

namespace walkcycle {
namespace {

TEST(DiagnosticTest, saysWhereWhatAndHowToMendIt) {
    const Diagnostic diagnostic{.severity = Severity::Error,
                                .code = "WC0207",
                                .file = "model.dae",
                                .line = 653,
                                .elementPath = {},
                                .message = "<skin> has no <vertex_weights>",
                                .cure = "re-export with weights"};

    EXPECT_EQ(toString(diagnostic),
              "model.dae:653: error WC0207: <skin> has no <vertex_weights> (re-export with weights)");
}

TEST(DiagnosticTest, leavesOutWhatIsNotKnown) {
    const Diagnostic diagnostic{.severity = Severity::Warning,
                                .code = "WC0101",
                                .file = "model.dae",
                                .elementPath = {},
                                .message = "odd",
                                .cure = {}};

    EXPECT_EQ(toString(diagnostic), "model.dae: warning WC0101: odd");
}

TEST(DiagnosticTest, countsTheOnesItStandsFor) {
    Diagnostic diagnostic;
    diagnostic.severity = Severity::Info;
    diagnostic.message = "odd";
    diagnostic.repeats = 12;

    EXPECT_EQ(toString(diagnostic), "info: odd [and 12 more like it]");
}

}  // namespace
}  // namespace walkcycle
