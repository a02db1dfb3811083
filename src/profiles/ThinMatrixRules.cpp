#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "profiles/Rules.h"

// Rules of the parser of ThinMatrix's series on skeletal animation, from its code. The headings below name its classes:
// https://github.com/TheThinMatrix/OpenGL-Animation (ColladaParser)
namespace walkcycle {
namespace {

constexpr std::size_t kJointsPerVertex = 3;  // GeneralSettings.MAX_WEIGHTS

// ---- the text (XmlParser, which reads line by line)

// XmlParser skips the first line, and takes each later line as one tag; an element without children has its text and
// its end tag in the same line.
void checkLayout(const Subject& subject) {
    std::size_t faults = 0;
    XmlNode firstFault;
    int line = 0;
    const auto note = [&](XmlNode where, int at) {
        if (faults++ == 0) firstFault = where, line = at;
    };
    if (subject.collada().line() != 2) note(subject.collada(), subject.collada().line());
    int lineBefore = 0;
    for (const XmlNode element : subject.elements()) {
        if (element.line() == lineBefore) note(element, element.line());
        lineBefore = element.line();
        if (element.commentLine() > 0) note(element, element.commentLine());
    }
    if (faults > 0) subject.report(Code::TmLayout, firstFault, {std::to_string(faults)}, line);
}

// The series splits lists with Java's String.split(" "), which gives an empty word for a leading space and for two
// spaces in a row. An empty word is not a number, so parsing it fails.
bool splitsBadly(std::string_view text) {
    const std::size_t end = text.find_last_not_of(' ');
    if (end == std::string_view::npos) return false;
    return text.front() == ' ' || text.substr(0, end).find("  ") != std::string_view::npos ||
           text.find_first_of("\t\r\n") != std::string_view::npos;
}

void checkTexts(const Subject& subject) {
    for (const XmlNode element : subject.elements()) {
        for (const auto& [name, value] : element.attributes())
            if (value.empty() || value.find(' ') != std::string_view::npos)
                subject.report(Code::TmAttribute, element, {std::string(name), std::string(value)});
        if (element.firstChild()) continue;
        std::string joined;
        const std::string_view text = element.rawText(joined);
        const bool isList = isOneOf(element, {"float_array", "Name_array", "p", "v", "vcount", "matrix"});
        if (text.find('\n') != std::string_view::npos || (isList && splitsBadly(text)))
            subject.report(Code::TmText, element, {std::string(element.name())});
    }
}

// ---- geometry (GeometryLoader)

void checkWidth(const Subject& subject, XmlNode source, const char* what, int expected) {
    if (accessorOf(source) && strideOf(source) != expected)
        subject.report(Code::TmSourceWidth, accessorOf(source),
                       {what, std::to_string(expected), std::to_string(strideOf(source))});
}

// GeometryLoader takes indices 0, 1 and 2 of a corner for VERTEX, NORMAL and TEXCOORD, and expects as many
// indices as there are <input>s.
void checkInputs(const Subject& subject, XmlNode polylist) {
    int inputs = 0;
    for (const XmlNode input : polylist.children("input")) inputs += static_cast<bool>(input);
    const char* wanted[] = {"VERTEX", "NORMAL", "TEXCOORD"};
    bool fits = inputs == indicesPerCorner(polylist);
    for (int offset = 0; offset < 3; ++offset) {
        const XmlNode input = inputOf(polylist, wanted[offset]);
        fits &= input && offsetOf(input) == offset;
    }
    if (!fits) subject.report(Code::TmInputs, polylist, {});
}

void checkPolylist(const Subject& subject, XmlNode mesh, XmlNode polylist) {
    checkInputs(subject, polylist);
    const std::vector<std::int32_t> counts = integersOf(polylist.child("vcount"));
    const auto others = std::count_if(counts.begin(), counts.end(), [](int count) { return count != 3; });
    if (others > 0) subject.report(Code::TmTriangles, polylist, {std::to_string(others)});
    checkWidth(subject, subject.follow(mesh.child("vertices").child("input"), "source"), "positions", 3);
    checkWidth(subject, subject.sourceOf(polylist, "NORMAL"), "normals", 3);
    checkWidth(subject, subject.sourceOf(polylist, "TEXCOORD"), "texture coordinates", 2);
    for (XmlNode other = polylist.nextSibling("polylist"); other; other = other.nextSibling("polylist"))
        subject.report(Code::TmOnlyFirst, other, {"<polylist>"});
}

void checkGeometry(const Subject& subject, XmlNode geometry) {
    const XmlNode mesh = geometry.child("mesh"), polylist = mesh.child("polylist");
    if (!polylist) return subject.report(Code::TmPolylist, mesh ? mesh : geometry, {});
    checkPolylist(subject, mesh, polylist);
    for (const XmlNode other : mesh.children())
        if (isOneOf(other, {"triangles", "polygons", "trifans", "tristrips", "lines", "linestrips"}))
            subject.report(Code::TmOnlyFirst, other, {"<polylist>"});
    if (!mesh.child("vertices").child("input").attribute("semantic").starts_with("POSITION"))
        subject.report(Code::TmInputs, mesh.child("vertices"), {});
}

// ---- skins (SkinLoader)

void checkSkin(const Subject& subject, XmlNode skin, XmlNode geometry) {
    const XmlNode meant = subject.follow(skin, "source");
    if (geometry && meant && !(meant == geometry))
        subject.report(Code::TmOtherGeometry, skin, {nameOf(geometry), nameOf(meant)});
    const XmlNode shape = skin.child("bind_shape_matrix");
    if (shape && !isIdentity(matrixOf(numbersOf(shape)))) subject.report(Code::TmBindShape, shape, {});
    const ManyInfluences many = verticesWithMoreJoints(subject, skin, kJointsPerVertex);
    if (many.vertices > 0)
        subject.report(Code::TmManyInfluences, skin.child("vertex_weights"),
                       {std::to_string(many.vertices), std::to_string(many.most)});
}

void reportOthers(const Subject& subject, XmlNode first, const char* name) {
    for (XmlNode other = first.nextSibling(name); other; other = other.nextSibling(name))
        subject.report(Code::TmOnlyFirst, other, {"<" + std::string(name) + ">"});
}

void checkAsset(const Subject& subject) {
    const XmlNode asset = subject.collada().child("asset");
    const XmlNode axis = asset.child("up_axis"), unit = asset.child("unit");
    if (subject.model().asset.upAxis != UpAxis::Z)
        subject.report(Code::TmUpAxis,
                       axis    ? axis
                       : asset ? asset
                               : subject.collada(),
                       {subject.model().asset.upAxis == UpAxis::Y ? "Y" : "X"});
    if (unit && subject.model().asset.metersPerUnit != 1.0)
        subject.report(Code::TmUnit, unit, {std::string(unit.attribute("meter"))});
}

}  // namespace

void checkThinMatrix(const Subject& subject) {
    checkLayout(subject);
    checkTexts(subject);
    checkAsset(subject);
    const XmlNode geometry = subject.collada().child("library_geometries").child("geometry");
    const XmlNode controllers = subject.collada().child("library_controllers");
    const XmlNode skin = controllers.child("controller").child("skin");
    if (geometry) checkGeometry(subject, geometry);
    if (skin)
        checkSkin(subject, skin, geometry);
    else
        subject.report(Code::TmNoSkin, controllers ? controllers : subject.collada(), {});
    reportOthers(subject, geometry, "geometry");
    reportOthers(subject, controllers.child("controller"), "controller");
    checkThinMatrixMotion(subject);
}

}  // namespace walkcycle
