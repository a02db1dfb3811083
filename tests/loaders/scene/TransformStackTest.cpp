#include <cmath>
#include <string>

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <gmock/gmock.h>

#include "loaders/LoadText.h"
#include "loaders/scene/TransformStack.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The local transform of a node with these elements, and what was said about them.
struct Stack {
    explicit Stack(const std::string& elements)
        : load(collada(scene("<node id='n'>" + elements + "</node>"))),
          stack(readTransformStack(load.byId("n"), load.diagnostics)),
          matrix(stack.toMatrix()) {}

    glm::dvec3 moves(const glm::dvec3& point) const { return glm::dvec3(matrix * glm::dvec4(point, 1.0)); }

    TestLoad load;
    TransformStack stack;
    glm::dmat4 matrix;
};

void expectNear(const glm::dvec3& is, const glm::dvec3& expected) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(is[i], expected[i], 1e-12) << "component " << i;
}

TEST(TransformStackTest, matrixIsReadRowByRowAndItsLastRowIgnored) {
    const Stack s("<matrix>1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16</matrix>");
    expectNear(s.moves({1, 0, 0}), {5, 13, 21});
    EXPECT_EQ(s.matrix[3].w, 1.0);
    EXPECT_EQ(s.matrix[0].w, 0.0);
}

TEST(TransformStackTest, theFirstElementIsAppliedLast) {
    const Stack s(
        "<translate>1 0 0</translate><rotate>0 0 1 90</rotate><scale>2 3 4</scale><translate>0 1 "
        "0</translate>");
    expectNear(s.moves({1, 0, 0}), {1 - 3, 2, 0});
}

TEST(TransformStackTest, anAxisOfAnyLengthIsNormalised) {
    expectNear(Stack("<rotate>0 0 1e-30 90</rotate>").moves({1, 0, 0}), {0, 1, 0});
    expectNear(Stack("<rotate>0 0 1e30 90</rotate>").moves({1, 0, 0}), {0, 1, 0});
}

TEST(TransformStackTest, aZeroAxisTurnsNothingAndIsReported) {
    const Stack s("<rotate>0 0 0 90</rotate>");
    EXPECT_EQ(s.matrix, glm::dmat4(1.0));
    EXPECT_THAT(codes(s.load.diagnostics.all()), ElementsAre("WC0711"));
    EXPECT_THAT(Stack("<rotate>0 0 0 0</rotate>").load.diagnostics.all(), IsEmpty());
}

TEST(TransformStackTest, lookatStandsAtTheEyeAndLooksAlongMinusZ) {
    const Stack s("<lookat>10 2 0  0 2 0  0 1 0</lookat>");
    expectNear(s.moves({0, 0, 0}), {10, 2, 0});
    expectNear(s.moves({0, 0, -1}), {9, 2, 0});
    expectNear(s.moves({0, 1, 0}), {10, 3, 0});
}

TEST(TransformStackTest, theMatrixOfEachElementIsAffine) {
    for (const char* text :
         {"<lookat>10 2 3  0 2 0  0 1 0</lookat>", "<skew>45  0 2 0  3 0 0</skew>",
          "<rotate>1 2 3 40</rotate>", "<translate>1 2 3</translate>", "<scale>2 3 4</scale>",
          "<matrix>1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16</matrix>"}) {
        const Stack s(text);
        EXPECT_EQ(glm::row(s.matrix, 3), glm::dvec4(0, 0, 0, 1)) << text;
    }
}

TEST(TransformStackTest, aDegenerateLookatChoosesAnotherUp) {
    for (const char* text : {"<lookat>0 5 0 0 0 0 0 1 0</lookat>", "<lookat>0 5 0 0 0 0 0 0 0</lookat>",
                             "<lookat>1 1 1 1 1 1 0 1 0</lookat>"}) {
        const Stack s(text);
        EXPECT_NEAR(glm::determinant(glm::dmat3(s.matrix)), 1.0, 1e-12);
        EXPECT_THAT(codes(s.load.diagnostics.all()), ElementsAre("WC0711"));
    }
    expectNear(Stack("<lookat>0 5 0 0 0 0 0 1 0</lookat>").moves({0, 0, -5}), {0, 0, 0});
}

// 45 degrees from y towards x: a point moves along x by its height.
TEST(TransformStackTest, skewMovesAlongTheSecondAxisByTheDistanceAcross) {
    const Stack s("<skew>45  0 2 0  3 0 0</skew>");
    expectNear(s.moves({0, 1, 0}), {1, 1, 0});
    expectNear(s.moves({1, 0, 5}), {1, 0, 5});
    EXPECT_THAT(codes(Stack("<skew>45 0 1 0 0 1 0</skew>").load.diagnostics.all()), ElementsAre("WC0711"));
}

// The turned axis leans 30 degrees already; 30 more bring it to 60 from the vertical.
TEST(TransformStackTest, skewTurnsItsFirstAxisByTheAngle) {
    const Stack s("<skew>30  0.5 0.8660254037844386 0  1 0 0</skew>");
    const glm::dvec3 leaning = s.moves({0.5, 0.8660254037844386, 0});
    EXPECT_NEAR(leaning.x / leaning.y, std::sqrt(3.0), 1e-9);
}

TEST(TransformStackTest, missingNumbersDoNothingAndAreReportedWithTheirLine) {
    const Stack s("<scale>2 2</scale>\n<translate sid='t'>1 2 3 4</translate>");
    expectNear(s.moves({1, 1, 1}), {4, 6, 4});
    ASSERT_THAT(codes(s.load.diagnostics.all()), ElementsAre("WC0710", "WC0710"));
    EXPECT_EQ(s.load.diagnostics.all()[1].line, s.load.diagnostics.all()[0].line + 1);
}

TEST(TransformStackTest, aViewAlongItsUpDirectionTakesAnotherOne) {
    const Stack down("<lookat>0 5 0 0 0 0 0 1 0</lookat>"), ahead("<lookat>0 0 5 0 0 0 0 0 1</lookat>");
    expectNear(down.moves({0, 0, -1}), {0, 4, 0});
    expectNear(ahead.moves({0, 0, -1}), {0, 0, 4});
    EXPECT_THAT(codes(down.load.diagnostics.all()), ElementsAre("WC0711"));
    EXPECT_THAT(codes(ahead.load.diagnostics.all()), ElementsAre("WC0711"));
}

TEST(TransformStackTest, aSkewWithoutAnAxisOrPastItsOtherAxisIsNone) {
    for (const char* skew :
         {"45 0 0 0 1 0 0", "45 1 0 0 0 0 0", "45 1 0 0 2 0 0", "90 0 1 0 1 0 0", "120 0 1 0 1 0 0"}) {
        const Stack s("<skew>" + std::string(skew) + "</skew>");
        expectNear(s.moves({1, 2, 3}), {1, 2, 3});
        EXPECT_THAT(codes(s.load.diagnostics.all()), ElementsAre("WC0711")) << skew;
    }
    EXPECT_THAT(Stack("<skew>0 0 1 0 1 0 0</skew>").load.diagnostics.all(), IsEmpty());
}

}  // namespace
}  // namespace walkcycle
