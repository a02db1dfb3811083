#include <cstddef>
#include <string>
#include <vector>

#include "ProfileCase.h"

namespace walkcycle {
namespace {

void expectTm(const std::vector<Change>& changes, const char* code, const std::string& marker,
              const char* pathEnd) {
    expectSaid(Profile::ThinMatrix, changed(changes), code, marker, pathEnd);
}

// ---- the text

TEST(ThinMatrixRulesTest, twoTagsInALineAreOneTooMany) {
    expectTm({{"<mesh>\n        <source id=\"body-positions\">", "<mesh><source id=\"body-positions\">"}},
             "WC1070", "<source id=\"body-positions\"", "source[id=body-positions]");
}

TEST(ThinMatrixRulesTest, aCommentCountsAsATag) {
    expectTm({{"      <mesh>", "      <mesh>\n<!-- made by hand -->"}}, "WC1070", "<!--",
             "geometry[id=body-mesh]/mesh");
}

TEST(ThinMatrixRulesTest, theFirstLineIsSkipped) {
    expectTm({{"<?xml version=\"1.0\" encoding=\"utf-8\"?>\n", ""}}, "WC1070", "<COLLADA", "COLLADA");
}

TEST(ThinMatrixRulesTest, numbersStandInOneLine) {
    expectTm({{"count=\"3\">0 -1 0<", "count=\"3\">0 -1\n0<"}}, "WC1071",
             "<float_array id=\"body-normals-array\"", "float_array[id=body-normals-array]");
}

TEST(ThinMatrixRulesTest, twoSpacesMakeAnEmptyNumber) {
    expectTm({{"count=\"3\">0 -1 0<", "count=\"3\">0  -1 0<"}}, "WC1071",
             "<float_array id=\"body-normals-array\"", "float_array[id=body-normals-array]");
}

TEST(ThinMatrixRulesTest, aSpaceAtTheEndIsFine) {
    EXPECT_THAT(said(Profile::ThinMatrix, changed({{"count=\"3\">0 -1 0<", "count=\"3\">0 -1 0 <"}})),
                testing::IsEmpty());
}

TEST(ThinMatrixRulesTest, attributesHoldNoSpaces) {
    expectTm({{"name=\"paint\"", "name=\"red paint\""}}, "WC1072", "<material id",
             "material[id=body-material]");
}

// ---- the parts

TEST(ThinMatrixRulesTest, aSkinMustBeThere) {
    const std::string text = cleanDocument();
    const std::size_t begin = text.find("<library_controllers>"), end = text.find("</library_controllers>");
    std::string still = text.substr(0, begin) + "<library_controllers>\n  " + text.substr(end);
    const std::string instance = "<instance_controller url=\"#body-skin\">";
    still.replace(still.find(instance), instance.size(), "<instance_geometry url=\"#body-mesh\">");
    still.replace(still.find("          <skeleton>#mPelvis</skeleton>\n"), 40, "");
    still.replace(still.find("</instance_controller>"), 22, "</instance_geometry>");
    expectSaid(Profile::ThinMatrix, still, "WC1073", "<library_controllers>", "COLLADA/library_controllers");
}

TEST(ThinMatrixRulesTest, aSecondPartIsMissing) {
    expectTm({{"        </polylist>\n",
               "        </polylist>\n        <triangles count=\"1\">\n<input semantic=\"VERTEX\" "
               "source=\"#body-vertices\" "
               "offset=\"0\"/>\n<p>0 1 2</p>\n</triangles>\n"}},
             "WC1074", "<triangles", "mesh/triangles");
}

TEST(ThinMatrixRulesTest, theFirstGeometryIsTakenForTheFirstSkin) {
    expectTm({{"    <geometry id=\"body-mesh\" name=\"body\">",
               "    <geometry id=\"hat\" name=\"hat\">\n<mesh/>\n</geometry>\n"
               "    <geometry id=\"body-mesh\" name=\"body\">"}},
             "WC1075", "<skin source", "controller[id=body-skin]/skin");
}

TEST(ThinMatrixRulesTest, trianglesAreNotRead) {
    expectTm({{"<polylist", "<triangles"},
              {"          <vcount>3 3</vcount>\n", ""},
              {"</polylist>", "</triangles>"}},
             "WC1076", "<mesh>", "geometry[id=body-mesh]/mesh");
}

TEST(ThinMatrixRulesTest, theOrderOfInputsIsFixed) {
    expectTm({{"source=\"#body-normals\" offset=\"1\"", "source=\"#body-normals\" offset=\"2\""},
              {"source=\"#body-map\" offset=\"2\"", "source=\"#body-map\" offset=\"1\""},
              {"<p>0 0 0 1 0 1 2 0 2 0 0 0 2 0 2 3 0 3</p>", "<p>0 0 0 1 1 0 2 2 0 0 0 0 2 2 0 3 3 0</p>"}},
             "WC1077", "<polylist", "mesh/polylist");
}

TEST(ThinMatrixRulesTest, polygonsAreTakenForTriangles) {
    expectTm({{"<vcount>3 3</vcount>", "<vcount>4</vcount>"},
              {"<p>0 0 0 1 0 1 2 0 2 0 0 0 2 0 2 3 0 3</p>", "<p>0 0 0 1 0 1 2 0 2 3 0 3</p>"}},
             "WC1078", "<polylist", "mesh/polylist");
}

TEST(ThinMatrixRulesTest, textureCoordinatesOfThreeNumbersAreMisread) {
    expectTm({{"count=\"8\">0 0 1 0 1 1 0 1<", "count=\"12\">0 0 0 1 0 0 1 1 0 0 1 0<"},
              {"count=\"4\" stride=\"2\"", "count=\"4\" stride=\"3\""}},
             "WC1079", "<accessor source=\"#body-map-array\"",
             "source[id=body-map]/technique_common/accessor");
}

TEST(ThinMatrixRulesTest, onlyThreeJointsOfAVertexAreKept) {
    expectTm({{"<vcount>1 1 2 1</vcount>", "<vcount>4 1 2 1</vcount>"},
              {"<v>0 0 0 0 0 1 1 1 1 0</v>", "<v>0 0 1 0 0 1 1 1 0 0 0 1 1 1 1 0</v>"}},
             "WC1080", "<vertex_weights", "skin/vertex_weights");
}

TEST(ThinMatrixRulesTest, aBindShapeIsIgnored) {
    expectTm({{"<bind_shape_matrix>1 0 0 0", "<bind_shape_matrix>1 0 0 3"}}, "WC1086", "<bind_shape_matrix>",
             "skin/bind_shape_matrix");
}

TEST(ThinMatrixRulesTest, everyModelIsTurnedAsForZUp) {
    expectTm({{"Z_UP", "Y_UP"}}, "WC1096", "<up_axis>", "asset/up_axis");
}

TEST(ThinMatrixRulesTest, theUnitIsIgnored) {
    expectTm({{"meter=\"1\"", "meter=\"0.01\""}}, "WC1097", "<unit", "asset/unit");
}

}  // namespace
}  // namespace walkcycle
