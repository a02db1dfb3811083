#include <string>
#include <vector>

#include "loaders/CodeCases.h"

namespace walkcycle {
namespace {

const std::string kGeometry = "COLLADA/library_geometries/geometry[id=mesh]";
const std::string kMesh = kGeometry + "/mesh/";
const std::string kVertex = "<input semantic='VERTEX' source='#v' offset='0'/>";

std::string manyTexCoordSets() {
    std::string inputs;
    for (int set = 0; set < 33; ++set)
        inputs += std::string(set == 32 ? "@" : "") +
                  "<input semantic='TEXCOORD' source='#p' offset='0' set='" + std::to_string(set) + "'/>\n";
    return "<triangles count='1'>" + kVertex + "\n" + inputs + "<p>0 1 2</p></triangles>\n";
}

}  // namespace

std::vector<CodeCase> geometryCases() {
    const std::string triangles = "<triangles count='1'>" + kVertex + "\n";
    return {
        {Code::IndexOutOfRange, meshOf(triangles + "<p>0\n1\n@7</p></triangles>\n"), kMesh + "triangles/p"},
        {Code::IncompleteFace, meshOf(triangles + "<p>0 1 2\n@0</p></triangles>\n"), kMesh + "triangles/p"},
        {Code::VcountMismatch,
         meshOf("<polylist count='1'>" + kVertex + "\n@<vcount>4</vcount>\n<p>0 1 2</p></polylist>\n"),
         kMesh + "polylist/vcount"},
        {Code::FaceTooSmall,
         meshOf("<polylist count='1'>" + kVertex + "\n@<vcount>2</vcount>\n<p>0 1</p></polylist>\n"),
         kMesh + "polylist"},
        {Code::InputMissing, meshOf("@<triangles count='1'>\n<p>0 1 2</p></triangles>\n"),
         kMesh + "triangles"},
        {Code::SourceWidth,
         meshOf(floatSource("n", "0 1", "X") + "<triangles count='1'>" + kVertex +
                "\n@<input semantic='NORMAL' source='#n' offset='0'/>\n<p>0 1 1</p></triangles>\n"),
         kMesh + "triangles/input"},
        {Code::ZeroAreaFaces, meshOf("@" + triangles + "<p>0 1 1</p></triangles>\n"), kMesh + "triangles"},
        {Code::ShapeNotDrawn,
         showing("<library_geometries><geometry id='mesh'>\n@<spline/></geometry></library_geometries>\n"),
         kGeometry + "/spline"},
        {Code::ConvexHullOf,
         showing(triangle("whole") +
                 "<library_geometries><geometry id='mesh'>\n"
                 "@<convex_mesh convex_hull_of='#whole'/></geometry></library_geometries>\n"),
         kGeometry + "/convex_mesh"},
        {Code::NormalsInvalid,
         meshOf(floatSource("n", "0 0 0") + "@<triangles count='1'>" + kVertex +
                "\n<input semantic='NORMAL' source='#n' offset='1'/>\n<p>0 0 1 0 2 0</p></triangles>\n"),
         kMesh + "triangles"},
        {Code::TooManyTexCoordSets, meshOf(manyTexCoordSets()), kMesh + "triangles/input"},
    };
}

}  // namespace walkcycle
