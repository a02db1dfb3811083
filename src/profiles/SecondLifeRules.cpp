#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "profiles/Rules.h"
#include "profiles/SecondLifeJoints.h"

// Rules for the contents that the uploader of Second Life's viewer skips or rejects. The headings below name its
// functions: https://github.com/secondlife/viewer (indra/llprimitive/lldaeloader.cpp and llmodelloader.cpp)
namespace walkcycle {
namespace {

constexpr std::size_t kMostJoints = 110;          // LL_MAX_JOINTS_PER_MESH_OBJECT
constexpr std::size_t kMostFaces = 8;             // LL_SCULPT_MESH_MAX_FACES
constexpr std::size_t kMostCorners = 65535;       // VERTEX_NUMBER_OVERFLOW
constexpr std::size_t kTrianglesPerFace = 21844;  // a longer <polylist> is split, at 65532 indices
constexpr std::size_t kJointsPerVertex = 4;       // processDomModel

bool isRead(XmlNode primitive) {
    return isOneOf(primitive, {"triangles", "polylist", "polygons"});
}

// ---- geometry (get_dom_sources, load_face_from_dom_*)

// Per entry of a source: the index of the first entry that holds the same numbers.
std::vector<std::int32_t> firstEqual(const Subject& subject, XmlNode source) {
    const std::vector<double>& numbers = subject.numbers(source.child("float_array"));
    const auto width = static_cast<std::size_t>(std::max(1, strideOf(source)));
    std::map<std::vector<double>, std::int32_t> seen;
    std::vector<std::int32_t> first;
    for (std::size_t at = 0; at + width <= numbers.size(); at += width) {
        const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(at);
        const std::vector<double> entry(begin, begin + static_cast<std::ptrdiff_t>(width));
        first.push_back(seen.try_emplace(entry, static_cast<std::int32_t>(first.size())).first->second);
    }
    return first;
}

// <source> -> its firstEqual(), computed once.
using EqualEntries = std::unordered_map<XmlNode, std::vector<std::int32_t>>;

// The number of vertices that the uploader makes of a primitive: of corners that differ in position, normal or texture
// coordinates. Returns 0, without comparing, if there are too few corners to reach the limit.
std::size_t differentCorners(const Subject& subject, XmlNode primitive, EqualEntries& known) {
    std::vector<std::int32_t> indices;
    for (const XmlNode p : primitive.children("p")) {
        const std::vector<std::int32_t> more = integersOf(p);
        indices.insert(indices.end(), more.begin(), more.end());
    }
    const auto stride = static_cast<std::size_t>(indicesPerCorner(primitive));
    if (indices.size() / stride < kMostCorners) return 0;
    // The offset of each <input>, and firstEqual() of its source.
    std::vector<std::pair<std::size_t, const std::vector<std::int32_t>*>> inputs;
    for (const XmlNode input : primitive.children("input")) {
        const XmlNode target = subject.follow(input, "source");
        const XmlNode source = target.is("vertices") ? subject.sourceOf(target, "POSITION") : target;
        const auto [entry, isNew] = known.try_emplace(source);
        if (isNew) entry->second = firstEqual(subject, source);
        inputs.emplace_back(static_cast<std::size_t>(offsetOf(input)), &entry->second);
    }
    std::set<std::vector<std::int32_t>> corners;
    for (std::size_t first = 0; first + stride <= indices.size(); first += stride) {
        std::vector<std::int32_t> corner;
        for (const auto& [offset, equal] : inputs) {
            const auto index = static_cast<std::size_t>(std::max(0, indices[first + offset]));
            corner.push_back(index < equal->size() ? (*equal)[index] : -1);
        }
        corners.insert(std::move(corner));
    }
    return corners.size();
}

void checkWidth(const Subject& subject, XmlNode source, const char* what, int expected,
                std::unordered_set<XmlNode>& seen) {
    if (accessorOf(source) && strideOf(source) != expected && seen.insert(source).second)
        subject.report(Code::SlSourceWidth, accessorOf(source),
                       {what, std::to_string(expected), std::to_string(strideOf(source))});
}

void checkSources(const Subject& subject, XmlNode primitive, std::unordered_set<XmlNode>& seen) {
    const XmlNode vertices = subject.sourceOf(primitive, "VERTEX");
    checkWidth(subject, subject.sourceOf(vertices, "POSITION"), "positions", 3, seen);
    int sets = 0;
    for (const XmlNode parent : {primitive, vertices}) {
        checkWidth(subject, subject.sourceOf(parent, "NORMAL"), "normals", 3, seen);
        for (const XmlNode input : parent.children("input"))
            if (input.attribute("semantic") == "TEXCOORD") {
                checkWidth(subject, subject.follow(input, "source"), "texture coordinates", 2, seen);
                ++sets;
            }
    }
    if (sets > 1) subject.report(Code::SlTexCoordSets, primitive, {std::to_string(sets)});
}

// The number of Second Life faces that a primitive becomes: a long <polylist> is split.
std::size_t facesOf(XmlNode primitive) {
    if (!primitive.is("polylist")) return 1;
    std::size_t triangles = 0;
    for (const std::int32_t count : integersOf(primitive.child("vcount")))
        triangles += count > 2 ? static_cast<std::size_t>(count - 2) : 0;
    return std::max<std::size_t>(1, (triangles + kTrianglesPerFace - 1) / kTrianglesPerFace);
}

void checkMesh(const Subject& subject, XmlNode mesh) {
    std::size_t faces = 0;
    std::unordered_set<XmlNode> seen;
    EqualEntries equal;
    for (const XmlNode primitive : mesh.children()) {
        if (isOneOf(primitive, {"lines", "linestrips", "trifans", "tristrips"}))
            subject.report(Code::SlPrimitive, primitive, {std::string(primitive.name())});
        if (primitive.child("ph")) subject.report(Code::SlPrimitive, primitive.child("ph"), {"ph"});
        if (!isRead(primitive)) continue;
        faces += facesOf(primitive);
        checkSources(subject, primitive, seen);
        if (primitive.is("polylist")) continue;
        const std::size_t corners = differentCorners(subject, primitive, equal);
        if (corners >= kMostCorners)
            subject.report(Code::SlVertices, primitive,
                           {std::string(primitive.name()), std::to_string(corners)});
    }
    if (faces > kMostFaces)
        subject.report(Code::SlFaces, mesh,
                       {std::to_string(faces), std::to_string((faces + kMostFaces - 1) / kMostFaces)});
}

// ---- skins (verifyController, processDomModel, critiqueRigForUploadApplicability)

void checkJoints(const Subject& subject, XmlNode skin) {
    const XmlNode source = subject.sourceOf(skin.child("joints"), "JOINT");
    const XmlNode array =
        source.child("Name_array") ? source.child("Name_array") : source.child("IDREF_array");
    if (!array) return;
    const std::vector<std::string> names = wordsOf(array);
    if (names.size() > kMostJoints)
        subject.report(Code::SlTooManyJoints, array, {std::to_string(names.size())});
    for (const std::string& name : names)
        if (!isSecondLifeJoint(name)) subject.report(Code::SlJointName, array, {name});
}

void checkWeights(const Subject& subject, XmlNode skin) {
    const XmlNode weights = skin.child("vertex_weights");
    const ManyInfluences many = verticesWithMoreJoints(subject, skin, kJointsPerVertex);
    if (many.vertices > 0)
        subject.report(Code::SlManyInfluences, weights,
                       {std::to_string(many.vertices), std::to_string(many.most)});
    const XmlNode mesh = subject.follow(skin, "source").child("mesh");
    const XmlNode positions = subject.follow(mesh.child("vertices").child("input"), "source");
    const int claimed = integerAttribute(weights, "count", -1);
    const int held = integerAttribute(accessorOf(positions), "count", -1);
    if (claimed >= 0 && held >= 0 && claimed != held)
        subject.report(Code::SlWeightCount, weights, {std::to_string(claimed), std::to_string(held)});
}

void checkControllers(const Subject& subject) {
    std::unordered_set<XmlNode> seen;
    for (const ShownMesh& shown : subject.shown())
        for (const XmlNode controller : shown.controllers) {
            if (!seen.insert(controller).second) continue;
            if (controller.is("morph")) {
                subject.report(Code::SlMorph, controller, {nameOf(controller.parent())});
                continue;
            }
            if (!controller.child("bind_shape_matrix"))
                subject.report(Code::SlBindShapeMissing, controller, {nameOf(controller.parent())});
            checkJoints(subject, controller);
            checkWeights(subject, controller);
        }
}

// ---- nodes (processElement)

void checkTransformsOf(const Subject& subject, XmlNode node) {
    for (const XmlNode element : node.children()) {
        if (isOneOf(element, {"skew", "lookat"}))
            subject.report(Code::SlTransform, element, {std::string(element.name())});
        if (!element.is("scale")) continue;
        const std::vector<double> factors = numbersOf(element);
        if (std::any_of(factors.begin(), factors.end(), [](double factor) { return factor < 0.0; }))
            subject.report(Code::SlNegativeScale, element, {nameOf(node)});
    }
}

// Per node: whether the <matrix>es of the node and of its ancestors mirror the meshes below it, that is, whether an odd
// number of them mirrors.
std::vector<bool> mirroredNodes(const Subject& subject) {
    std::vector<bool> mirrored;
    for (std::size_t i = 0; i < subject.scene().nodes.size(); ++i) {
        const int parent = subject.parent(static_cast<int>(i));
        bool isMirrored = parent != kNoParent && mirrored[static_cast<std::size_t>(parent)];
        for (const XmlNode matrix : subject.scene().nodes[i].children("matrix"))
            if (glm::determinant(matrixOf(numbersOf(matrix))) < 0.0) isMirrored = !isMirrored;
        mirrored.push_back(isMirrored);
    }
    return mirrored;
}

void checkTransforms(const Subject& subject) {
    const std::vector<bool> mirrored = mirroredNodes(subject);
    std::unordered_set<XmlNode> elements;
    std::unordered_set<int> nodes;
    for (const ShownMesh& shown : subject.shown()) {
        if (!shown.instance.is("instance_geometry")) continue;
        if (mirrored[static_cast<std::size_t>(shown.node)])
            subject.report(Code::SlMirrored, shown.instance, {nameOf(subject.element(shown.node))});
        for (int node = shown.node; node != kNoParent && nodes.insert(node).second;
             node = subject.parent(node))
            if (elements.insert(subject.element(node)).second)
                checkTransformsOf(subject, subject.element(node));
    }
}

// ---- materials (profileToMaterial)

void checkMaterials(const Subject& subject) {
    for (const XmlNode texture : subject.all("texture"))
        if (enclosing(texture, "profile_COMMON") && !texture.parent().is("diffuse"))
            subject.report(Code::SlTextureSlot, texture, {std::string(texture.parent().name())});
    for (const XmlNode image : subject.all("image")) {
        const XmlNode from = image.child("init_from");
        const std::string extension = extensionOf(from.text());
        static constexpr std::string_view kRead[] = {"", "bmp", "tga", "jpg", "jpeg", "png", "j2c", "jp2"};
        if (std::find(std::begin(kRead), std::end(kRead), extension) == std::end(kRead))
            subject.report(Code::SlPictureFormat, from, {from.text()});
    }
}

}  // namespace

void checkSecondLife(const Subject& subject) {
    std::unordered_set<XmlNode> geometries;
    for (const ShownMesh& shown : subject.shown()) {
        if (shown.geometry && geometries.insert(shown.geometry).second)
            checkMesh(subject, shown.geometry.child("mesh"));
    }
    checkTransforms(subject);
    checkControllers(subject);
    checkMaterials(subject);
    const XmlNode animations = subject.collada().child("library_animations");
    if (animations.child("animation")) subject.report(Code::SlAnimations, animations, {});
}

}  // namespace walkcycle
