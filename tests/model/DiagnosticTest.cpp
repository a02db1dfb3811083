#include <string>

#include <gtest/gtest.h>

#include "walkcycle/model/Diagnostic.h"

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

TEST(DiagnosticTest, namesTheElementWithoutTheRoot) {
    const Diagnostic diagnostic{.severity = Severity::Error,
                                .code = "WC0207",
                                .file = "model.dae",
                                .line = 653,
                                .elementPath = "COLLADA/library_controllers/controller[id=body]/skin",
                                .message = "<skin> has no <vertex_weights>",
                                .cure = "re-export with weights"};

    EXPECT_EQ(toString(diagnostic),
              "model.dae:653: error WC0207: <skin> has no <vertex_weights>, in "
              "library_controllers/controller[id=body]/skin (re-export with weights)");
}

TEST(DiagnosticTest, aLongPathLosesItsBeginningButNotTheLastId) {
    Diagnostic diagnostic;
    diagnostic.message = "odd";
    diagnostic.elementPath = "COLLADA/library_visual_scenes/visual_scene[id=s]";
    for (const char* joint : {"pelvis", "spine", "chest", "neck", "shoulder", "elbow"})
        diagnostic.elementPath.append("/node[id=").append(joint).append("]");
    diagnostic.elementPath += "/node[sid=wrist]/matrix";
    EXPECT_EQ(
        toString(diagnostic),
        "error: odd, in "
        ".../node[id=pelvis]/node[id=spine]/node[id=chest]/node[id=neck]/node[id=shoulder]/node[id=elbow]/"
        "node[sid=wrist]/matrix");

    const std::string id(150, 'x');
    diagnostic.elementPath = "COLLADA/library_geometries/geometry[id=" + id + "]/mesh";
    EXPECT_EQ(toString(diagnostic), "error: odd, in .../geometry[id=" + id + "]/mesh");
}

TEST(DiagnosticTest, theDocumentAsAWholeIsNoElementToName) {
    Diagnostic diagnostic;
    diagnostic.message = "odd";
    diagnostic.elementPath = "COLLADA";

    EXPECT_EQ(toString(diagnostic), "error: odd");
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
