#include <string>
#include <string_view>
#include <unordered_set>

#include "profiles/Rules.h"

// Rules from the function LoadController of Gazebo's loader. GazeboRules.cpp has its address.
namespace walkcycle {
namespace {

// The names that Gazebo's LoadSingleSkeletonNode gives to nodes: the sid, else the name, else the id.
std::unordered_set<std::string> jointNames(const Subject& subject) {
    std::unordered_set<std::string> names;
    for (const XmlNode node : subject.all("node")) {
        const std::string_view sid = node.sid(), name = node.attribute("name");
        names.emplace(!sid.empty() ? sid : !name.empty() ? name : node.id());
    }
    return names;
}

void checkJointNames(const Subject& subject, XmlNode skin, const std::unordered_set<std::string>& known) {
    const XmlNode source = subject.sourceOf(skin.child("joints"), "JOINT");
    const XmlNode names = source.child("Name_array");
    if (!names) {
        if (source) subject.report(Code::GazeboJointArray, source, {nameOf(skin.parent())});
        return;
    }
    for (const std::string& word : wordsOf(names))
        if (!known.contains(word)) subject.report(Code::GazeboJointName, names, {word});
}

void checkBindShape(const Subject& subject, const ShownMesh& shown, XmlNode skin) {
    const XmlNode shape = skin.child("bind_shape_matrix");
    if (!shape) return subject.report(Code::GazeboBindShapeMissing, skin, {nameOf(skin.parent())});
    const bool hasTriangles = shown.geometry && shown.geometry.child("mesh").child("triangles");
    if (hasTriangles && !isIdentity(matrixOf(numbersOf(shape))))
        subject.report(Code::GazeboBindShapeIgnored, shape, {nameOf(shown.geometry)});
}

void checkSkin(const Subject& subject, const ShownMesh& shown, XmlNode skin,
               const std::unordered_set<std::string>& joints) {
    checkBindShape(subject, shown, skin);
    checkJointNames(subject, skin, joints);
    const XmlNode weights = skin.child("vertex_weights");
    const int advance = offsetOf(inputOf(weights, "JOINT")) + offsetOf(inputOf(weights, "WEIGHT")) + 1;
    if (weights && advance != indicesPerCorner(weights))
        subject.report(Code::GazeboWeightOffsets, weights, {});
    if (!isIdentity(subject.world(shown.node)))
        subject.report(Code::GazeboSkinNode, shown.instance, {nameOf(subject.element(shown.node))});
}

}  // namespace

void checkGazeboSkins(const Subject& subject) {
    const std::unordered_set<std::string> joints = jointNames(subject);
    std::unordered_set<XmlNode> seen;
    for (const ShownMesh& shown : subject.shown())
        for (const XmlNode controller : shown.controllers) {
            if (!seen.insert(controller).second) continue;
            if (controller.is("morph"))
                subject.report(Code::GazeboMorph, controller, {nameOf(controller.parent())});
            else
                checkSkin(subject, shown, controller, joints);
        }
}

}  // namespace walkcycle
