#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "profiles/Rules.h"

// Rules for the contents that a glTF 2.0 file cannot hold, or that its viewers may ignore. The numbers are sections of
// https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
namespace walkcycle {
namespace {

constexpr std::size_t kJointsPerVertex = 4;    // 3.7.3.3: more joints need JOINTS_1, which viewers may ignore
constexpr std::size_t kTexCoordSets = 2;       // 3.7.2.1
constexpr std::size_t kMorphedAttributes = 8;  // 3.7.2.2

// ---- geometry

void checkPrimitives(const Subject& subject) {
    for (const char* name : {"polylist", "polygons", "triangles", "trifans", "tristrips"})
        for (const XmlNode primitive : subject.all(name)) {
            std::unordered_set<std::string> sources;
            for (const XmlNode input : primitive.children("input"))
                if (input.attribute("semantic") == "TEXCOORD") sources.emplace(input.attribute("source"));
            if (sources.size() > kTexCoordSets)
                subject.report(Code::GltfTexCoordSets, primitive, {std::to_string(sources.size())});
        }
    for (const XmlNode polylist : subject.all("polylist")) {
        const std::vector<std::int32_t> counts = integersOf(polylist.child("vcount"));
        const auto larger = std::count_if(counts.begin(), counts.end(), [](int count) { return count > 3; });
        if (larger > 0) subject.report(Code::GltfPolygons, polylist, {std::to_string(larger)});
    }
}

// ---- the scene

bool isSheared(const glm::dmat4& matrix) {
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a(matrix[i]), b(matrix[(i + 1) % 3]);
        const double lengths = glm::length(a) * glm::length(b);
        if (lengths > 0.0 && std::abs(glm::dot(a, b)) > 1e-3 * lengths) return true;
    }
    return false;
}

void checkNodes(const Subject& subject) {
    std::unordered_set<XmlNode> seen;  // an instanced node occurs several times
    for (std::size_t i = 0; i < subject.scene().stacks.size(); ++i) {
        const XmlNode node = subject.scene().nodes[i];
        if (seen.insert(node).second && isSheared(subject.scene().stacks[i].toMatrix()))
            subject.report(Code::GltfShear, node, {nameOf(node)});
    }
    if (subject.model().animations.empty()) return;
    for (const Channel& channel : subject.model().animations.front().channels)
        if (!channel.matrixKeyFrames.empty()) {
            const XmlNode node = subject.element(channel.joint);
            subject.report(Code::GltfShearAnimated, node, {nameOf(node)});
        }
}

void checkLight(const Subject& subject, XmlNode light) {
    const XmlNode common = light.child("technique_common");
    if (common.child("ambient")) return subject.report(Code::GltfAmbientLight, light, {nameOf(light)});
    const bool isLamp = common.child("point") || common.child("spot") || common.child("directional");
    if (isLamp) subject.report(Code::GltfLight, light, {nameOf(light)});
}

void checkCamera(const Subject& subject, XmlNode camera) {
    const XmlNode common = camera.child("optics").child("technique_common");
    const XmlNode perspective = common.child("perspective"), orthographic = common.child("orthographic");
    const XmlNode optics = perspective ? perspective : orthographic;
    if (!optics) return;
    const bool hasAspect = static_cast<bool>(optics.child("aspect_ratio"));
    const auto x = static_cast<bool>(optics.child(perspective ? "xfov" : "xmag"));
    const auto y = static_cast<bool>(optics.child(perspective ? "yfov" : "ymag"));
    const bool complete = perspective ? y || (x && hasAspect) : (x && y) || ((x || y) && hasAspect);
    if (!complete)
        subject.report(Code::GltfCameraOptics, camera,
                       {nameOf(camera), perspective ? "yfov" : "xmag and ymag"});
}

void checkCamerasAndLights(const Subject& subject) {
    std::unordered_set<XmlNode> seen;
    for (const SceneGraph::Instance& instance : subject.scene().lights) {
        const XmlNode light = subject.follow(instance.element, "url");
        if (light && seen.insert(light).second) checkLight(subject, light);
    }
    for (const SceneGraph::Instance& instance : subject.scene().cameras) {
        const XmlNode camera = subject.follow(instance.element, "url");
        if (camera && seen.insert(camera).second) checkCamera(subject, camera);
    }
}

void checkOtherScenes(const Subject& subject) {
    for (const XmlNode other : subject.collada().child("scene").children())
        if (isOneOf(other, {"instance_physics_scene", "instance_kinematics_scene"}))
            subject.report(Code::GltfPhysics, other, {std::string(other.name())});
}

// ---- deformers

void checkDeformers(const Subject& subject) {
    std::unordered_set<XmlNode> seen;
    for (const ShownMesh& shown : subject.shown()) {
        bool skinned = false, wrongOrder = false;  // innermost first
        for (auto controller = shown.controllers.rbegin(); controller != shown.controllers.rend();
             ++controller) {
            wrongOrder |= skinned;
            skinned |= controller->is("skin");
            if (!seen.insert(*controller).second) continue;
            if (controller->is("morph")) continue;
            const ManyInfluences many = verticesWithMoreJoints(subject, *controller, kJointsPerVertex);
            if (many.vertices > 0)
                subject.report(Code::GltfManyInfluences, controller->child("vertex_weights"),
                               {std::to_string(many.vertices), std::to_string(many.most)});
        }
        if (wrongOrder)
            subject.report(Code::GltfDeformerOrder, shown.instance, {nameOf(shown.instance.parent())});
    }
}

void checkMorphs(const Subject& subject) {
    for (const MorphTargets& morph : subject.model().morphs) {
        std::size_t attributes = 0;
        for (const MorphTarget& target : morph.targets) attributes += target.normalDeltas.empty() ? 1 : 2;
        const XmlNode controller = subject.collada().elementById(morph.id);
        if (attributes > kMorphedAttributes && controller.child("morph"))
            subject.report(Code::GltfMorphTargets, controller.child("morph"),
                           {std::to_string(morph.targets.size()), std::to_string(attributes)});
    }
}

// ---- animation

void checkCurves(const Subject& subject) {
    std::unordered_set<XmlNode> seen;
    for (const XmlNode sampler : subject.all("sampler")) {
        const XmlNode names = subject.sourceOf(sampler, "INTERPOLATION").child("Name_array");
        if (!names || !seen.insert(names).second) continue;
        const std::vector<std::string> words = wordsOf(names);
        const auto curves = std::count_if(words.begin(), words.end(), [](const std::string& word) {
            return word == "BEZIER" || word == "HERMITE" || word == "CARDINAL" || word == "BSPLINE";
        });
        if (curves > 0) subject.report(Code::GltfCurves, names, {std::to_string(curves)});
    }
}

// glTF animates node transforms and morph weights, nothing else.
void checkChannels(const Subject& subject) {
    for (const XmlNode channel : subject.all("channel")) {
        const ChannelTarget target = subject.targetOf(channel);
        const bool isProperty = isOneOf(target.root, {"camera", "light", "effect", "material"});
        const bool isVisibility = target.root.is("node") && enclosing(target.element, "extra");
        if (target.element && (isProperty || isVisibility))
            subject.report(Code::GltfAnimatedProperty, channel, {std::string(channel.attribute("target"))});
    }
}

// ---- materials

void checkPictures(const Subject& subject) {
    std::unordered_set<std::string> used;
    for (const Texture& texture : subject.model().textures) used.insert(texture.id);
    for (const XmlNode image : subject.all("image")) {
        const XmlNode from = image.child("init_from");
        const std::string uri = from.child("ref") ? from.child("ref").text() : from.text();
        const std::string extension = extensionOf(uri);
        if (used.contains(std::string(image.id())) && !extension.empty() && extension != "png" &&
            extension != "jpg" && extension != "jpeg")
            subject.report(Code::GltfPictureFormat, from, {uri});
    }
    for (const char* name : {"wrap_s", "wrap_t"})
        for (const XmlNode wrap : subject.all(name))
            if (wrap.text() == "BORDER" || wrap.text() == "NONE")
                subject.report(Code::GltfBorderWrap, wrap, {std::string(wrap.name()), wrap.text()});
}

void checkSlots(const Subject& subject) {
    for (const XmlNode texture : subject.all("texture")) {
        const XmlNode slot = texture.parent();
        if (isOneOf(slot, {"ambient", "specular", "reflective"}))
            subject.report(Code::GltfTextureSlot, texture, {std::string(slot.name())});
        const XmlNode diffuse = slot.parent().child("diffuse").child("texture");
        if (slot.is("transparent") && diffuse.attribute("texture") != texture.attribute("texture"))
            subject.report(Code::GltfTransparentTexture, texture, {});
    }
}

}  // namespace

void checkGltf(const Subject& subject) {
    checkPrimitives(subject);
    checkNodes(subject);
    checkCamerasAndLights(subject);
    checkOtherScenes(subject);
    checkDeformers(subject);
    checkMorphs(subject);
    checkCurves(subject);
    checkChannels(subject);
    checkPictures(subject);
    checkSlots(subject);
}

}  // namespace walkcycle
