#include "loaders/scene/SkeletonLoader.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "loaders/context/AssetReader.h"
#include "loaders/document/LoadProgress.h"
#include "loaders/text/Spelling.h"

namespace walkcycle {

void SkeletonLoader::addScene(XmlNode visualScene) {
    if (!visualScene.child("node"))
        context_.diagnostics.report(Severity::Warning, Code::MissingElement, visualScene,
                                    {"visual_scene", "node"});
    for (XmlNode node : visualScene.children("node")) add({node, kNoParent, rootCollada_}, true);
}

int SkeletonLoader::addUndrawn(XmlNode node) {
    const int joint = static_cast<int>(scene_.skeleton.joints.size());
    add({node, kNoParent, rootCollada_}, false);
    return joint;
}

// Walks the nodes depth first with an explicit stack, because a file may nest them as deep as it likes. The
// limit on nodes also bounds how often <instance_node>s repeat them.
void SkeletonLoader::add(const Visit& root, bool drawn) {
    std::vector<Visit> waiting{root};
    while (!waiting.empty()) {
        const Visit visit = waiting.back();
        waiting.pop_back();
        if (visit.instanced) countInstanced(visit.node);
        context_.require(scene_.nodes.size() + 1 + waiting.size(), &LoadLimits::maxNodes, visit.node);
        context_.require(visit.depth, &LoadLimits::maxSceneDepth, visit.node);
        const int joint = addJoint(visit, drawn);
        context_.advance(LoadProgress::kPerNode);
        if (drawn) addInstances(visit.node, joint);
        const std::vector<Visit> children = childrenOf(visit, joint);
        waiting.insert(waiting.end(), children.rbegin(), children.rend());
    }
}

// Counts the elements that <instance_node>s repeat: the node itself, its transforms and its instances.
void SkeletonLoader::countInstanced(XmlNode node) {
    ++instancedElements_;
    for (XmlNode child = node.firstChild(); child; child = child.nextSibling()) ++instancedElements_;
    context_.require(instancedElements_, &LoadLimits::maxInstancedElements, node);
}

// Whether all numbers of the joint's model transform at rest are small enough that floats can hold one more
// product with it. Appends that transform to worlds_.
bool SkeletonLoader::reachesWorld(const Joint& joint) {
    constexpr double kLargest = 1e18;
    const glm::dmat4 local(joint.localBindTransform);
    worlds_.push_back(joint.parent == kNoParent ? local
                                                : worlds_[static_cast<std::size_t>(joint.parent)] * local);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(worlds_.back()[column][row]) < kLargest)) return false;
    return true;
}

int SkeletonLoader::addJoint(const Visit& visit, bool drawn) {
    const XmlNode node = visit.node;
    const int index = static_cast<int>(scene_.nodes.size());
    TransformStack stack = readTransformStack(node, context_.diagnostics);
    const glm::dmat4 outer = assetConversion(node, visit.around, asset_, rootCollada_);

    Joint joint;
    joint.name = node.attribute("name");
    joint.id = node.id();
    joint.sid = node.sid();
    nodeText_ += joint.name.size() + joint.id.size() + joint.sid.size();
    context_.require(nodeText_, &LoadLimits::maxNodeText, node);
    joint.parent = visit.parent;
    const std::string_view type = node.attribute("type");
    joint.isJoint = type == "JOINT";
    if (!type.empty() && type != "JOINT" && type != "NODE")
        context_.diagnostics.report(Code::WordUnknown, node,
                                    {std::string(type), "node", didYouMean(type, "JOINT NODE")});
    joint.localBindTransform = glm::mat4(outer * stack.toMatrix());
    if (!reachesWorld(joint)) {
        context_.diagnostics.report(Code::TransformOverflow, node, {std::string(node.id())});
        joint.localBindTransform = glm::mat4(1.0f);
        worlds_.back() =
            visit.parent == kNoParent ? glm::dmat4(1.0) : worlds_[static_cast<std::size_t>(visit.parent)];
    }
    scene_.skeleton.joints.push_back(std::move(joint));
    scene_.nodes.push_back(node);
    scene_.stacks.push_back(std::move(stack));
    scene_.outer.push_back(outer);
    scene_.drawn.push_back(drawn);
    scene_.occurrences.emplace(node, index);
    return index;
}

void SkeletonLoader::addInstances(XmlNode node, int joint) {
    for (XmlNode element : node.children()) {
        if (element.is("instance_geometry")) scene_.geometries.push_back({joint, element});
        if (element.is("instance_controller")) scene_.controllers.push_back({joint, element});
        if (element.is("instance_camera")) scene_.cameras.push_back({joint, element});
        if (element.is("instance_light")) scene_.lights.push_back({joint, element});
    }
}

std::vector<SkeletonLoader::Visit> SkeletonLoader::childrenOf(const Visit& visit, int joint) {
    const XmlNode node = visit.node;
    std::vector<Visit> children;
    for (XmlNode element : node.children()) {
        if (element.is("node")) children.push_back({element, joint, node, visit.instanced, visit.depth + 1});
        if (!element.is("instance_node")) continue;
        const XmlNode target = context_.documents.follow(element, "url", "node");
        if (target && isInside(target, joint))
            context_.diagnostics.report(Code::ReferenceLoop, element,
                                        {"instance_node", std::string(element.attribute("url"))});
        else if (target)
            children.push_back({target, joint, node, true, visit.depth + 1});
    }
    return children;
}

// Whether `joint` is an occurrence of `node`, or below one. Instancing `node` there would never end.
bool SkeletonLoader::isInside(XmlNode node, int joint) const {
    for (; joint != kNoParent; joint = scene_.skeleton.joints[static_cast<std::size_t>(joint)].parent)
        if (scene_.nodes[static_cast<std::size_t>(joint)] == node) return true;
    return false;
}

}  // namespace walkcycle
