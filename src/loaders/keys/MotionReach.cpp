#include "loaders/keys/MotionReach.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>

#include "animation/MatrixKeys.h"
#include "walkcycle/animation/Animator.h"

namespace walkcycle {

namespace {

// The size of a large mesh is measured with about so many of its points.
constexpr std::size_t kPointsLookedAt = 8'000;

std::size_t strideOf(std::size_t count) {
    return count / kPointsLookedAt + 1;
}

double largestAxis(const glm::dmat4& m) {
    return std::max(
        {glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])), glm::length(glm::dvec3(m[2]))});
}

glm::dvec3 transformed(const glm::dmat4& m, const glm::dvec3& point) {
    return glm::dvec3(m[0]) * point.x + glm::dvec3(m[1]) * point.y + glm::dvec3(m[2]) * point.z +
           glm::dvec3(m[3]);
}

// Multiplies local transforms along the skeleton to model transforms.
void chain(const std::vector<Joint>& joints, std::vector<glm::dmat4>& locals) {
    for (std::size_t i = 0; i < joints.size(); ++i)
        if (joints[i].parent != kNoParent)
            locals[i] = locals[static_cast<std::size_t>(joints[i].parent)] * locals[i];
}

}  // namespace

// Computes two opposite corners at a time: the centre plus and minus the same half diagonal.
double MotionReach::Box::farthestSquared(const glm::dmat4& matrix) const {
    const glm::dvec3 middle = 0.5 * (min + max), half = 0.5 * (max - min);
    const glm::dmat3 linear(matrix);
    const glm::dvec3 at = linear * middle + glm::dvec3(matrix[3]);
    const glm::dvec3 x = linear[0] * half.x, y = linear[1] * half.y, z = linear[2] * half.z;
    double most = 0.0;
    for (const glm::dvec3& diagonal : {x + y + z, x + y - z, x - y + z, x - y - z})
        most = std::max(most, glm::dot(diagonal, diagonal) + 2.0 * std::abs(glm::dot(at, diagonal)));
    return glm::dot(at, at) + most;
}

MotionReach::MotionReach(const Model& model, const Motion& motion, double seconds)
    : worlds_(model.skeleton.joints.size()), boxes_(worlds_.size()) {
    std::vector<double> parameters(model.parameters.size());
    motion.evaluate(seconds, worlds_, parameters);
    chain(model.skeleton.joints, worlds_);
    Box modelBox, origins;
    for (const MeshInstance& instance : model.instances) addInstance(model, instance, modelBox);
    for (const glm::dmat4& world : worlds_) origins.add(glm::dvec3(world[3]));
    const Box& seen = modelBox.empty() ? origins : modelBox;
    const double size = seen.empty() ? 0.0 : glm::length(seen.max - seen.min);
    if (size > 0.0 && std::isfinite(size)) modelSize_ = size;
    measureJoints(model);
    countMoving(model, motion);
}

void MotionReach::addInstance(const Model& model, const MeshInstance& instance, Box& modelBox) {
    for (const Deformer& deformer : instance.deformers)
        if (deformer.kind == Deformer::Kind::Skin) return addSkinned(model, instance, deformer, modelBox);
    const auto node = static_cast<std::size_t>(instance.node);
    const auto& positions = model.meshes[static_cast<std::size_t>(instance.mesh)].positions;
    Box box;
    for (std::size_t i = 0; i < positions.size(); i += strideOf(positions.size())) box.add(positions[i]);
    if (box.empty()) return;
    for (int i = 0; i < 8; ++i) {
        boxes_[node].add(box.corner(i));
        modelBox.add(transformed(worlds_[node], box.corner(i)));
    }
}

void MotionReach::addSkinned(const Model& model, const MeshInstance& instance, const Deformer& deformer,
                             Box& modelBox) {
    const Skin& skin = model.skins[static_cast<std::size_t>(deformer.index)];
    const Influences& all = model.influences[static_cast<std::size_t>(deformer.influences)];
    const auto& positions = model.meshes[static_cast<std::size_t>(instance.mesh)].positions;
    const std::vector<glm::dmat4> bind(skin.bindMatrices.begin(), skin.bindMatrices.end());
    for (std::size_t p = 0; p < positions.size() && p + 1 < all.first.size();
         p += strideOf(positions.size())) {
        glm::dvec3 posed(0.0);
        for (std::uint32_t i = all.first[p]; i < all.first[p + 1]; ++i) {
            const Influence& influence = all.influences[i];
            const auto joint = static_cast<std::size_t>(skin.joints[influence.joint]);
            const glm::dvec3 point = transformed(bind[influence.joint], positions[p]);
            boxes_[joint].add(point);
            posed += static_cast<double>(influence.weight) * transformed(worlds_[joint], point);
        }
        modelBox.add(posed);
    }
}

// Children come after their parents, so from the back the box of each joint is complete before the box of its
// parent takes it in.
void MotionReach::measureJoints(const Model& model) {
    const std::vector<Joint>& joints = model.skeleton.joints;
    std::vector<Box> hanging(joints.size());
    units_.assign(joints.size(), 1.0);
    reaches_.assign(joints.size(), 1.0);
    for (std::size_t i = joints.size(); i-- > 0;) {
        const glm::dvec3 origin(worlds_[i][3]);
        hanging[i].add(origin);
        for (int c = 0; c < 8 && !boxes_[i].empty(); ++c)
            hanging[i].add(transformed(worlds_[i], boxes_[i].corner(c)));
        double reach = 0.1 * modelSize_;  // an error of rotation counts even if the joint moves no point
        for (int c = 0; c < 8; ++c) reach = std::max(reach, glm::length(hanging[i].corner(c) - origin));
        const double own = largestAxis(worlds_[i]);
        reaches_[i] = own > 1e-12 * modelSize_ ? reach / own : 1.0;
        if (joints[i].parent == kNoParent) continue;
        const auto parent = static_cast<std::size_t>(joints[i].parent);
        units_[i] = std::max(largestAxis(worlds_[parent]), 1e-12);
        hanging[parent].add(hanging[i].min);
        hanging[parent].add(hanging[i].max);
    }
}

void MotionReach::countMoving(const Model& model, const Motion& motion) {
    const std::vector<Joint>& joints = model.skeleton.joints;
    std::vector<int> above(joints.size(), 0), below(joints.size(), 0);
    for (const JointMotion& moving : motion.joints) above[static_cast<std::size_t>(moving.joint)] = 1;
    const std::vector<int> itself = above;
    for (std::size_t i = 0; i < joints.size(); ++i)
        if (joints[i].parent != kNoParent) above[i] += above[static_cast<std::size_t>(joints[i].parent)];
    for (std::size_t i = joints.size(); i-- > 0;)
        if (joints[i].parent != kNoParent) {
            int& parent = below[static_cast<std::size_t>(joints[i].parent)];
            parent = std::max(parent, below[i] + itself[i]);
        }
    for (std::size_t i = 0; i < joints.size(); ++i) moving_.push_back(std::max(1, above[i] + below[i]));
}

// Errors along a chain rarely have one direction. Like the steps of a random walk, they add up to the square
// root of their number. measure() shows how far that is true.
Tolerance MotionReach::tolerance(int joint, double share) const {
    const auto i = static_cast<std::size_t>(joint);
    const double chain = std::sqrt(static_cast<double>(moving_[i]));
    return {std::max(share, finestShare()) * modelSize_ / chain, units_[i], reaches_[i]};
}

Tolerance MotionReach::tolerance(const Parameter& parameter, const Model& model, double share) const {
    share = std::max(share, finestShare());
    if (parameter.kind != ParameterKind::MorphWeight)
        return {share * std::max(1.0, std::abs(static_cast<double>(parameter.restValue))), 1.0, 0.0};
    const MorphTargets& morph = model.morphs[static_cast<std::size_t>(parameter.object)];
    double farthest = 1e-6 * modelSize_;
    for (const glm::vec3& delta : morph.targets[static_cast<std::size_t>(parameter.component)].positionDeltas)
        farthest = std::max(farthest, static_cast<double>(glm::length(delta)));
    return {0.5 * share * modelSize_, farthest, 0.0};
}

double MotionReach::measure(const Model& model, const Motion& motion, const Animation& animation) const {
    const std::vector<Joint>& joints = model.skeleton.joints;
    const auto moments = std::clamp<std::size_t>(20'000 / (joints.size() + 1), 12, 64);
    std::vector<glm::dmat4> exact(joints.size()), keyed(joints.size());
    std::vector<double> exactParameters(model.parameters.size());
    double farthest = 0.0;  // squared
    for (std::size_t m = 0; m < moments; ++m) {
        const double share = std::fmod((static_cast<double>(m) + 0.5) * 0.6180339887498949, 1.0);
        const double seconds = animation.startSeconds + share * animation.lengthInSeconds();
        motion.evaluate(seconds, exact, exactParameters);
        for (std::size_t i = 0; i < joints.size(); ++i) keyed[i] = exact[i];
        for (const Channel& channel : animation.channels)
            keyed[static_cast<std::size_t>(channel.joint)] =
                channel.keyFrames.empty() ? sampleMatrix(channel.matrixKeyFrames, seconds)
                                          : sample(channel, seconds).toMatrix();
        chain(joints, exact);
        chain(joints, keyed);
        for (std::size_t i = 0; i < joints.size(); ++i) {
            if (boxes_[i].empty()) continue;
            farthest = std::max(farthest, boxes_[i].farthestSquared(exact[i] - keyed[i]));
        }
    }
    return std::sqrt(farthest) / modelSize_;
}

}  // namespace walkcycle
