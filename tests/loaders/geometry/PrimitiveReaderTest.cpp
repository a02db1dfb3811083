#include <string>

#include <gmock/gmock.h>

#include "loaders/GeometryFixture.h"
#include "loaders/geometry/PrimitiveReader.h"

namespace walkcycle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kVertex = input("VERTEX", "verts", 0);
const std::string kFive = kSquare + " 0.5 2 0";

// The sources stand in lines 3 and 4, the primitive begins in line 5, and what is inside it in line 6.
GeometryFixture with(const std::string& kind, const std::string& inside, const std::string& count = "1") {
    return GeometryFixture(vertices(kFive) + "<" + kind + " count=\"" + count + "\">" + kVertex + inside +
                           "</" + kind + ">");
}

TEST(PrimitiveReaderTest, aBadIndexOfAFanOrStripIsFoundInItsLine) {
    for (const char* kind : {"trifans", "tristrips"}) {
        EXPECT_THAT(with(kind, "<p>0\n1\n2\n3\n9</p>").said(), Contains("WC0301:10")) << kind;
        EXPECT_THAT(with(kind, "<p>0\n1\n2\n9\n4</p>").said(), Contains("WC0301:9")) << kind;
        EXPECT_THAT(with(kind, "<p>0\n9\n2\n3\n4</p>").said(), Contains("WC0301:7")) << kind;
        EXPECT_THAT(with(kind, "<p>9\n1\n2\n3\n4</p>").said(), Contains("WC0301:6")) << kind;
        EXPECT_THAT(with(kind, "<p>0 1</p>\n<p>0 1 2</p>\n<p>0 1 2\n9</p>", "3").said(), Contains("WC0301:9"))
            << kind;
    }
    EXPECT_THAT(with("linestrips", "<p>0\n1\n9\n3</p>").said(), Contains("WC0301:8"));
}

TEST(PrimitiveReaderTest, aBadIndexIsFoundInItsListWhicheverItIs) {
    EXPECT_THAT(with("polygons", "<p>0 1 2</p>\n<p>0 1\n9</p>", "2").said(), ElementsAre("WC0301:8"));
    EXPECT_THAT(with("polygons", "<ph><p>0 1 2</p></ph>\n<ph><p>0 1 9</p></ph>", "2").said(),
                ElementsAre("WC0301:7"));
    EXPECT_THAT(with("polygons", "<ph><p>0 1 2 3</p><extra/>\n<h>0 1\n9</h></ph>").said(),
                Contains("WC0301:8"));
}

TEST(PrimitiveReaderTest, aPolylistThatHoldsNothingNeedsNoVcount) {
    EXPECT_THAT(with("polylist", "", "0").said(), IsEmpty());
    EXPECT_THAT(with("polylist", "<p/>", "0").said(), IsEmpty());
    EXPECT_THAT(with("polylist", "<p>0 1 2</p>", "0").said(), ElementsAre("WC0203:5"));
}

TEST(PrimitiveReaderTest, aNegativeVcountIsAnErrorEvenWhereTheSumIsRight) {
    const GeometryFixture mesh = with("polylist", "<vcount>3 -2 3</vcount>\n<p>0 1 2 0 2 3</p>", "3");
    EXPECT_THAT(mesh.said(), ElementsAre("WC0303:6"));
    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 1, 2));
}

TEST(PrimitiveReaderTest, onlyPolygonsHaveHoles) {
    const GeometryFixture fan = with("trifans", "<ph><p>0 1 2</p></ph>", "0");
    EXPECT_THAT(fan.drawnPositions(), IsEmpty());
    const GeometryFixture small = with("polygons", "<ph><p>0 1</p><h>0 1 2</h></ph>");
    EXPECT_THAT(small.said(), ElementsAre("WC0304:6"));
    EXPECT_THAT(small.drawnPositions(), IsEmpty());
}

TEST(PrimitiveReaderTest, theUnusualKindsAreDrawnLikeTheirTriangles) {
    EXPECT_THAT(with("trifans", "<p>0 1 2 3</p>").drawnPositions(), ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_THAT(with("tristrips", "<p>0 1 3 2</p>").drawnPositions(), ElementsAre(0, 1, 3, 3, 1, 2));
}

TEST(PrimitiveReaderTest, aLineWithAnEndThatIsNotThereIsLeftOut) {
    const GeometryFixture mesh = with("lines", "<p>0 1 9 2 2 9 2 3</p>", "4");
    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0301:6"));
}

// A triangle that a bad position spoils says nothing about its other numbers; the next one that shares them does.
TEST(PrimitiveReaderTest, aBadIndexIsFoundWhereATriangleSharesItWithOneThatIsLeftOut) {
    const auto said = [](const std::string& kind, const std::string& p) {
        return GeometryFixture(source("uv", 2, "0 0") + vertices(kFive) + "<" + kind + " count=\"1\">" +
                               kVertex + input("TEXCOORD", "uv", 1) + "<p>" + p + "</p></" + kind + ">")
            .said();
    };
    EXPECT_THAT(said("trifans", "0 9\n9 0\n2 0\n3 0"), ElementsAre("WC0301:9", "WC0301:8"));
    EXPECT_THAT(said("tristrips", "9 0\n1 0\n2 9\n3 0\n4 0"), ElementsAre("WC0301:8", "WC0301:10"));
    EXPECT_THAT(said("tristrips", "9 0\n1 9\n2 0\n3 0\n4 0"), ElementsAre("WC0301:8", "WC0301:9"));
}

}  // namespace
}  // namespace walkcycle
