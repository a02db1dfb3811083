#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "profiles/Rules.h"

// Rules for the elements that Gazebo's COLLADA loader skips or misreads. The loader belongs to gz-common:
// https://github.com/gazebosim/gz-common/blob/main/graphics/src/ColladaLoader.cc (gazebo-classic has an older version).
// The headings below name its functions.
namespace walkcycle {
namespace {

// ---- geometry (LoadGeometry, LoadTriangles, LoadPolylist)

// Gazebo cuts a polygon into a fan of triangles from its first corner. Returns whether a triangle of that fan faces the
// other way than the polygon, as happens if the polygon is concave.
bool fanHasFlippedTriangle(const std::vector<double>& positions, std::size_t width,
                           const std::vector<std::int32_t>& corners) {
    std::vector<glm::dvec3> points;
    for (const std::int32_t corner : corners) {
        const std::size_t first = static_cast<std::size_t>(std::max(0, corner)) * width;
        if (corner < 0 || first + 3 > positions.size()) return false;
        points.emplace_back(positions[first], positions[first + 1], positions[first + 2]);
    }
    glm::dvec3 whole(0.0);
    for (std::size_t i = 2; i < points.size(); ++i)
        whole += glm::cross(points[i - 1] - points[0], points[i] - points[0]);
    for (std::size_t i = 2; i < points.size(); ++i) {
        const glm::dvec3 part = glm::cross(points[i - 1] - points[0], points[i] - points[0]);
        if (glm::dot(part, whole) < -1e-3 * glm::dot(whole, whole)) return true;
    }
    return false;
}

void checkConcave(const Subject& subject, XmlNode polylist) {
    const XmlNode source = subject.sourceOf(subject.sourceOf(polylist, "VERTEX"), "POSITION");
    const int width = strideOf(source), stride = indicesPerCorner(polylist);
    if (width < 3) return;
    const std::vector<double>& positions = subject.numbers(source.child("float_array"));
    const std::vector<std::int32_t> p = integersOf(polylist.child("p"));
    std::size_t at = static_cast<std::size_t>(offsetOf(inputOf(polylist, "VERTEX"))), concave = 0;
    for (const std::int32_t count : integersOf(polylist.child("vcount"))) {
        std::vector<std::int32_t> corners;
        for (std::int32_t i = 0; i < count && at < p.size(); ++i, at += static_cast<std::size_t>(stride))
            corners.push_back(p[at]);
        concave += count > 3 && fanHasFlippedTriangle(positions, static_cast<std::size_t>(width), corners);
    }
    if (concave > 0) subject.report(Code::GazeboConcave, polylist, {std::to_string(concave)});
}

// Gazebo expects one index per <input> of a corner (for TEXCOORD, one per offset). If inputs share an offset or leave
// one out, it reads all later indices at wrong places.
void checkOffsets(const Subject& subject, XmlNode primitive) {
    std::set<int> texCoords;
    int counted = 0;
    for (const XmlNode input : primitive.children("input")) {
        if (input.attribute("semantic") == "TEXCOORD")
            texCoords.insert(offsetOf(input));
        else
            ++counted;
    }
    counted += static_cast<int>(texCoords.size());
    const int held = indicesPerCorner(primitive);
    if (counted != held)
        subject.report(Code::GazeboSharedOffsets, primitive,
                       {std::string(primitive.name()), std::to_string(counted), std::to_string(held)});
}

void checkSource(const Subject& subject, XmlNode source, int least, std::unordered_set<XmlNode>& seen) {
    const XmlNode accessor = accessorOf(source);
    if (!accessor || !seen.insert(source).second) return;
    const auto report = [&](const char* fault) {
        subject.report(Code::GazeboSource, accessor, {nameOf(source), fault});
    };
    if (!accessor.has("stride")) return report("its accessor has no stride");
    if (strideOf(source) < least) return report("its entries have too few numbers");
    if (!source.child("float_array").has("count")) return report("its float_array has no count");
    if (integerAttribute(accessor, "offset", 0) != 0) return report("the accessor's offset is not read");
    const XmlNode first = accessor.child("param");
    if (first && first.attribute("name").empty() && accessor.child("param").nextSibling("param").has("name"))
        report("the first <param> has no name, but is not skipped");
}

void checkPrimitive(const Subject& subject, XmlNode primitive, std::unordered_set<XmlNode>& seen) {
    checkOffsets(subject, primitive);
    if (primitive.is("polylist")) checkConcave(subject, primitive);
    const XmlNode vertices = subject.sourceOf(primitive, "VERTEX");
    for (const XmlNode parent : {primitive, vertices}) {
        checkSource(subject, subject.sourceOf(parent, "POSITION"), 3, seen);
        checkSource(subject, subject.sourceOf(parent, "NORMAL"), 3, seen);
        checkSource(subject, subject.sourceOf(parent, "TEXCOORD"), 2, seen);
    }
}

void checkGeometry(const Subject& subject, XmlNode geometry, std::unordered_set<XmlNode>& seen) {
    for (const char* shape : {"convex_mesh", "spline", "brep"})
        if (geometry.child(shape)) subject.report(Code::GazeboPrimitive, geometry.child(shape), {shape});
    for (const XmlNode primitive : geometry.child("mesh").children()) {
        if (isOneOf(primitive, {"polygons", "trifans", "tristrips", "linestrips"}))
            subject.report(Code::GazeboPrimitive, primitive, {std::string(primitive.name())});
        if (isOneOf(primitive, {"triangles", "polylist"})) checkPrimitive(subject, primitive, seen);
    }
}

// Per node: its rank in the order in which Gazebo visits the nodes, each after its descendants.
std::vector<std::size_t> visitRanks(const Skeleton& skeleton) {
    // The last entry has the roots.
    std::vector<std::vector<std::size_t>> children(skeleton.joints.size() + 1);
    for (std::size_t i = 0; i < skeleton.joints.size(); ++i) {
        const int parent = skeleton.joints[i].parent;
        children[parent == kNoParent ? skeleton.joints.size() : static_cast<std::size_t>(parent)].push_back(
            i);
    }
    // Gazebo's order from its end: parents before children, the last child first.
    std::vector<std::size_t> reversed, open = {skeleton.joints.size()};
    while (!open.empty()) {
        reversed.push_back(open.back());
        open.pop_back();
        open.insert(open.end(), children[reversed.back()].begin(), children[reversed.back()].end());
    }
    std::vector<std::size_t> rank(reversed.size());
    for (std::size_t i = 0; i < reversed.size(); ++i) rank[reversed[i]] = reversed.size() - i;
    return rank;
}

// Gazebo applies the node transform of a geometry's first instance to the geometry's positions (LoadPositions), and
// then uses these positions for all other instances, too.
void checkInstances(const Subject& subject) {
    const std::vector<std::size_t> rank = visitRanks(subject.scene().skeleton);
    std::vector<ShownMesh> shown = subject.shown();
    std::stable_sort(shown.begin(), shown.end(), [&](const ShownMesh& a, const ShownMesh& b) {
        return rank[static_cast<std::size_t>(a.node)] < rank[static_cast<std::size_t>(b.node)];
    });
    std::unordered_map<XmlNode, int> firstNode;
    std::unordered_set<XmlNode> seen;
    for (const ShownMesh& one : shown) {
        if (!one.geometry) continue;
        const auto [first, isNew] = firstNode.try_emplace(one.geometry, one.node);
        if (isNew)
            checkGeometry(subject, one.geometry, seen);
        else if (!isSame(subject.world(first->second), subject.world(one.node)))
            subject.report(Code::GazeboRepeatedGeometry, one.instance, {nameOf(one.geometry)});
    }
}

// ---- nodes (LoadNode, LoadNodeTransform)

// A node's transform as Gazebo reads it: the first <matrix> if there is one, otherwise the first <translate>, all
// <rotate>s and the first <scale>, in this order.
glm::dmat4 asGazeboReads(const TransformStack& stack) {
    using Kind = TransformElement::Kind;
    glm::dmat4 translation(1.0), rotation(1.0), scale(1.0);
    bool hasTranslation = false, hasScale = false;
    for (const TransformElement& element : stack.elements) {
        if (element.kind == Kind::Matrix) return element.toMatrix();
        if (element.kind == Kind::Rotate) rotation *= element.toMatrix();
        if (element.kind == Kind::Translate && !std::exchange(hasTranslation, true))
            translation = element.toMatrix();
        if (element.kind == Kind::Scale && !std::exchange(hasScale, true)) scale = element.toMatrix();
    }
    return translation * rotation * scale;
}

// Checks the nodes of meshes and joints, and their ancestors. Other nodes do not matter, because Gazebo does not read
// cameras and lights.
void checkTransforms(const Subject& subject) {
    std::set<int> checked;
    const auto add = [&](int node) {
        while (node != kNoParent && checked.insert(node).second) node = subject.parent(node);
    };
    for (const ShownMesh& shown : subject.shown()) add(shown.node);
    for (std::size_t i = 0; i < subject.scene().skeleton.joints.size(); ++i)
        if (subject.scene().skeleton.joints[i].isJoint) add(static_cast<int>(i));
    std::unordered_set<XmlNode> seen;
    for (const int i : checked) {
        const TransformStack& stack = subject.scene().stacks[static_cast<std::size_t>(i)];
        const XmlNode node = subject.element(i);
        if (seen.insert(node).second && !isSame(stack.toMatrix(), asGazeboReads(stack)))
            subject.report(Code::GazeboTransforms, node, {nameOf(node)});
    }
}

// After a node's first <instance_node>, Gazebo skips the rest of the node.
void checkInstanceNodes(const Subject& subject) {
    for (const XmlNode node : subject.all("node")) {
        const XmlNode first = node.child("instance_node");
        if (!first) continue;
        for (const XmlNode other : node.children())
            if (isOneOf(other, {"instance_node", "instance_geometry", "instance_controller"}) &&
                !(other == first))
                subject.report(Code::GazeboInstanceNode, other, {nameOf(node), std::string(other.name())});
    }
}

void checkNames(const Subject& subject) {
    for (const XmlNode node : subject.all("node"))
        if (!node.has("name") && node.parent().is("node") && !node.parent().has("name"))
            subject.report(Code::GazeboUnnamedNode, node, {nameOf(node)});
}

void checkScene(const Subject& subject) {
    if (!subject.collada().child("scene").child("instance_visual_scene"))
        subject.report(Code::GazeboNoScene, subject.collada(), {});
    if (subject.model().asset.upAxis != UpAxis::Z) {
        const XmlNode asset = subject.collada().child("asset"), axis = asset.child("up_axis");
        subject.report(Code::GazeboUpAxis,
                       axis    ? axis
                       : asset ? asset
                               : subject.collada(),
                       {subject.model().asset.upAxis == UpAxis::Y ? "Y" : "X"});
    }
    std::unordered_set<XmlNode> seen;
    for (const auto& instances : {subject.scene().cameras, subject.scene().lights})
        for (const SceneGraph::Instance& instance : instances)
            if (seen.insert(instance.element).second)
                subject.report(Code::GazeboNotRead, instance.element, {std::string(instance.element.name())});
}

// ---- references (ElementId)

// Gazebo resolves a reference to the first element in document order that has this id or sid, whatever its
// kind.
class GazeboLookup {
public:
    explicit GazeboLookup(const Subject& subject) {
        for (const XmlNode element : subject.elements())
            for (const std::string_view name : {element.id(), element.sid()})
                if (!name.empty()) first_.try_emplace(std::string(name), element);
    }
    XmlNode operator()(std::string_view name) const {
        const auto found = first_.find(std::string(name));
        return found == first_.end() ? XmlNode() : found->second;
    }

private:
    std::unordered_map<std::string, XmlNode> first_;
};

void reportAmbiguous(const Subject& subject, XmlNode from, std::string_view reference, XmlNode taken) {
    subject.report(Code::GazeboAmbiguousId, from,
                   {std::string(reference), std::string(taken.name()), std::to_string(taken.line())});
}

// The id or text of the image that a <newparam> leads to, through <sampler2D> and <surface>. `find` resolves each sid
// on the way.
template <typename Find>
std::string imageBehind(XmlNode parameter, Find find) {
    if (parameter.is("image")) return std::string(parameter.id());
    const XmlNode surface = find(parameter.child("sampler2D").child("source").text());
    return surface.child("surface").child("init_from").text();
}

// A <texture> names a <newparam> of its own effect by sid. Gazebo may find a <newparam> of an earlier effect
// that has the same sid.
void checkSamplers(const Subject& subject, const GazeboLookup& first) {
    // <profile_COMMON> -> its <newparam>s by sid
    std::unordered_map<XmlNode, std::unordered_map<std::string, XmlNode>> parameters;
    for (const XmlNode parameter : subject.all("newparam"))
        parameters[parameter.parent()].try_emplace(std::string(parameter.sid()), parameter);
    for (const XmlNode texture : subject.all("texture")) {
        const auto& ofProfile = parameters[enclosing(texture, "profile_COMMON")];
        const auto inProfile = [&](std::string_view sid) {
            const auto found = ofProfile.find(std::string(sid));
            return found == ofProfile.end() ? XmlNode() : found->second;
        };
        const std::string_view name = texture.attribute("texture");
        const XmlNode meant = inProfile(name), taken = first(name);
        if (!meant || !taken || imageBehind(meant, inProfile) == imageBehind(taken, first)) continue;
        const std::string surface = meant.child("sampler2D").child("source").text();
        reportAmbiguous(subject, texture, name, taken == meant ? first(surface) : taken);
    }
}

void checkReferences(const Subject& subject) {
    const GazeboLookup first(subject);
    for (const char* attribute : {"url", "source", "target"})
        for (const XmlNode element : subject.elements()) {
            const std::string_view uri = element.attribute(attribute);
            if (uri.size() < 2 || uri.front() != '#') continue;
            const XmlNode meant = subject.follow(element, attribute), taken = first(uri.substr(1));
            if (meant && taken && !(meant == taken)) reportAmbiguous(subject, element, uri.substr(1), taken);
        }
    checkSamplers(subject, first);
}

}  // namespace

void checkGazebo(const Subject& subject) {
    checkScene(subject);
    checkNames(subject);
    checkInstanceNodes(subject);
    checkTransforms(subject);
    checkInstances(subject);
    checkGazeboSkins(subject);
    checkReferences(subject);
    checkGazeboMotion(subject);
    checkGazeboMaterials(subject);
}

}  // namespace walkcycle
