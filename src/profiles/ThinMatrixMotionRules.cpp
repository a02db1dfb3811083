#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "profiles/Rules.h"

// Rules from the classes SkeletonLoader, AnimationLoader and Animator of the series. ThinMatrixRules.cpp has the
// address of its code.
namespace walkcycle {
namespace {

constexpr std::size_t kMostJoints = 50;  // AnimatedModelShader.MAX_JOINTS

// The joints as the series reads them: the first <node> within the node "Armature", and every <node> below
// that one; parents first.
struct Joints {
    std::vector<XmlNode> nodes;
    std::vector<glm::dmat4> rest;  // joint space -> space of the armature, by the <matrix>es
};

Joints jointsBelow(XmlNode armature) {
    Joints joints;
    std::vector<std::pair<XmlNode, glm::dmat4>> open;
    if (armature.child("node")) open.emplace_back(armature.child("node"), glm::dmat4(1.0));
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        joints.nodes.push_back(node);
        joints.rest.push_back(parent * matrixOf(numbersOf(node.child("matrix"))));
        for (const XmlNode child : node.children("node")) open.emplace_back(child, joints.rest.back());
    }
    return joints;
}

XmlNode findArmature(const Subject& subject) {
    const XmlNode scene = subject.collada().child("library_visual_scenes").child("visual_scene");
    for (const XmlNode node : scene.children("node"))
        if (node.id() == "Armature") return node;
    subject.report(Code::TmArmature, scene ? scene : subject.collada(), {});
    return {};
}

void checkArmature(const Subject& subject, XmlNode armature) {
    const auto found = std::find(subject.scene().nodes.begin(), subject.scene().nodes.end(), armature);
    if (found != subject.scene().nodes.end() &&
        !isIdentity(subject.world(static_cast<int>(found - subject.scene().nodes.begin()))))
        subject.report(Code::TmArmatureTransform, armature, {});
    const XmlNode root = armature.child("node");
    for (XmlNode other = root.nextSibling("node"); other; other = other.nextSibling("node"))
        subject.report(Code::TmOnlyFirst, other, {"joint of the armature"});
}

std::vector<std::string> jointNames(const Subject& subject, XmlNode skin) {
    const XmlNode source = subject.sourceOf(skin.child("vertex_weights"), "JOINT");
    if (source && !source.child("Name_array")) subject.report(Code::TmJointArray, source, {});
    return wordsOf(source.child("Name_array"));
}

void checkJoints(const Subject& subject, const Joints& joints, const std::vector<std::string>& names) {
    const std::unordered_set<std::string> known(names.begin(), names.end());
    for (const XmlNode node : joints.nodes) {
        if (!node.child("matrix")) subject.report(Code::TmMatrix, node, {nameOf(node)});
        if (!known.contains(std::string(node.id()))) subject.report(Code::TmJointId, node, {nameOf(node)});
    }
    if (joints.nodes.size() > kMostJoints)
        subject.report(Code::TmTooManyJoints, joints.nodes.front(), {std::to_string(joints.nodes.size())});
}

// The series inverts the rest pose instead of reading INV_BIND_MATRIX. The two agree if the mesh was bound in
// its rest pose.
void checkRestPose(const Subject& subject, XmlNode skin, const Joints& joints,
                   const std::vector<std::string>& names) {
    const XmlNode source = subject.sourceOf(skin.child("joints"), "INV_BIND_MATRIX");
    const std::vector<double> inverseBinds = numbersOf(source.child("float_array"));
    std::unordered_map<std::string_view, std::size_t> index;
    for (std::size_t i = 0; i < names.size(); ++i) index.emplace(names[i], i);
    // rest * inverse bind: mesh space -> space of the armature. If the mesh was bound in the rest pose, it is the same
    // for all joints.
    std::optional<glm::dmat4> common;
    for (std::size_t i = 0; i < joints.nodes.size(); ++i) {
        const auto joint = index.find(joints.nodes[i].id());
        if (joint == index.end() || (joint->second + 1) * 16 > inverseBinds.size()) continue;
        const glm::dmat4 moved = joints.rest[i] * matrixOf(inverseBinds, joint->second * 16);
        if (!common) common = moved;
        if (!isSame(*common, moved))
            subject.report(Code::TmRestPose, joints.nodes[i], {nameOf(joints.nodes[i])});
    }
}

// ---- animations (AnimationLoader)

struct Track {
    XmlNode animation, sampler, times, values;
    std::string joint;
};

std::vector<Track> tracksOf(const Subject& subject, XmlNode library) {
    std::vector<Track> tracks;
    for (const XmlNode animation : library.children("animation")) {
        Track track{animation, animation.child("sampler"), {}, {}, {}};
        const XmlNode channel = animation.child("channel");
        if (!track.sampler || !channel || !animation.child("source")) {
            subject.report(Code::TmNested, animation, {nameOf(animation)});
            continue;
        }
        track.times = subject.sourceOf(track.sampler, "INPUT");
        track.values = subject.sourceOf(track.sampler, "OUTPUT");
        const std::string_view target = channel.attribute("target");
        track.joint = target.substr(0, target.find('/'));
        tracks.push_back(std::move(track));
    }
    return tracks;
}

// The series takes the first <float_array> of the first <animation> as the key times of all animations.
void checkTimes(const Subject& subject, XmlNode library, const std::vector<Track>& tracks) {
    const XmlNode array = library.child("animation").child("source").child("float_array");
    const std::vector<double>& times = subject.numbers(array);
    if (array && times.size() < 2) subject.report(Code::TmOneKey, array, {std::to_string(times.size())});
    if (times.size() > 1 && times.front() > 0.0)
        subject.report(Code::TmLateStart, array, {wordsOf(array).front()});
    for (const Track& track : tracks)
        if (track.times && subject.contents(track.times.child("float_array")) != subject.contents(array))
            subject.report(Code::TmKeyTimes, track.times, {track.joint});
}

bool isScaled(const glm::dmat4& matrix) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(glm::length(glm::dvec3(matrix[axis])) - 1.0) > 1e-2) return true;
    return false;
}

void checkValues(const Subject& subject, const std::vector<Track>& tracks) {
    std::unordered_set<XmlNode> seen;
    for (const Track& track : tracks) {
        if (!track.values || !seen.insert(track.values).second) continue;
        if (strideOf(track.values) != 16) {
            subject.report(Code::TmNotMatrix, track.values,
                           {track.joint, std::to_string(strideOf(track.values))});
            continue;
        }
        const std::vector<double>& numbers = subject.numbers(track.values.child("float_array"));
        for (std::size_t first = 0; first + 16 <= numbers.size(); first += 16)
            if (isScaled(matrixOf(numbers, first))) {
                subject.report(Code::TmScale, track.values, {track.joint});
                break;
            }
    }
}

void checkInterpolation(const Subject& subject, const std::vector<Track>& tracks) {
    std::unordered_set<XmlNode> seen;
    for (const Track& track : tracks) {
        const XmlNode names = subject.sourceOf(track.sampler, "INTERPOLATION").child("Name_array");
        if (!names || !seen.insert(names).second) continue;
        const std::vector<std::string> words = wordsOf(names);
        const auto others = std::count_if(words.begin(), words.end(),
                                          [](const std::string& word) { return word != "LINEAR"; });
        if (others > 0) subject.report(Code::TmInterpolation, names, {std::to_string(others)});
    }
}

void checkAnimations(const Subject& subject, const Joints& joints) {
    const XmlNode library = subject.collada().child("library_animations");
    if (!library.child("animation"))
        return subject.report(Code::TmNoAnimation, library ? library : subject.collada(), {});
    const std::vector<Track> tracks = tracksOf(subject, library);
    checkTimes(subject, library, tracks);
    checkValues(subject, tracks);
    checkInterpolation(subject, tracks);
    std::unordered_set<std::string> moved;
    for (const Track& track : tracks) moved.insert(track.joint);
    for (const XmlNode joint : joints.nodes)
        if (!moved.contains(std::string(joint.id())))
            subject.report(Code::TmJointStill, joint, {nameOf(joint)});
}

}  // namespace

void checkThinMatrixMotion(const Subject& subject) {
    const XmlNode skin = subject.collada().child("library_controllers").child("controller").child("skin");
    const XmlNode armature = findArmature(subject);
    const Joints joints = jointsBelow(armature);
    if (armature) checkArmature(subject, armature);
    if (skin && armature) {
        const std::vector<std::string> names = jointNames(subject, skin);
        checkJoints(subject, joints, names);
        checkRestPose(subject, skin, joints, names);
    }
    checkAnimations(subject, joints);
}

}  // namespace walkcycle
