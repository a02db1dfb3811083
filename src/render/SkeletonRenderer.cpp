#include "render/SkeletonRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <glm/geometric.hpp>

namespace walkcycle {
namespace {

constexpr glm::vec4 kFace{0.85f, 0.45f, 0.05f, 1.0f};  // linear light
constexpr glm::vec4 kEdge{0.10f, 0.04f, 0.00f, 1.0f};

// Two unit vectors at right angles to a direction and to each other.
struct Frame {
    glm::vec3 across, other;
};

Frame frameAround(const glm::vec3& direction) {
    const glm::vec3 any =
        std::abs(direction.y) < 0.9f * glm::length(direction) ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 across = glm::normalize(glm::cross(direction, any));
    return {across, glm::normalize(glm::cross(direction, across))};
}

}  // namespace

std::vector<bool> shownJoints(const Model& model) {
    std::vector<bool> shown(model.skeleton.joints.size(), false);
    for (std::size_t i = 0; i < shown.size(); ++i) shown[i] = model.skeleton.joints[i].isJoint;
    for (const Skin& skin : model.skins) {
        // The last entry is the skin's own node.
        for (std::size_t i = 0; i + 1 < skin.joints.size(); ++i)
            shown[static_cast<std::size_t>(skin.joints[i])] = true;
    }
    return shown;
}

SkeletonRenderer::SkeletonRenderer()
    : program_({{"overlayVertex"}, {"flatFragment"}}),
      viewProjection_(program_.uniform("viewProjection")),
      flatColor_(program_.uniform("flatColor")),
      encodesItself_(program_.uniform("encodesItself")) {
    vao_.floats(0, positions_, 3);
}

void SkeletonRenderer::addShape(const glm::vec3& from, const glm::vec3& to, float width) {
    const glm::vec3 along = to - from;
    if (!(glm::length(along) > 0.0f)) return;
    const Frame frame = frameAround(along);
    const glm::vec3 waist = from + along * 0.15f;
    const std::array<glm::vec3, 4> ring{waist + frame.across * width, waist + frame.other * width,
                                        waist - frame.across * width, waist - frame.other * width};
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::vec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        triangles_.insert(triangles_.end(), {from, a, b, a, to, b});
        edges_.insert(edges_.end(), {from, a, a, b, a, to});
    }
}

void SkeletonRenderer::render(const AnimatedModel& model, const Camera& camera, bool encodesItself) {
    const std::vector<bool> shown = shownJoints(model.model());
    const auto& transforms = model.animator().modelTransforms();
    const float size = model.bounds().diagonal();
    triangles_.clear();
    edges_.clear();
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (!shown[i]) continue;
        const glm::vec3 here(transforms[i][3]);
        const int parent = model.model().skeleton.joints[i].parent;
        const glm::vec3 small(0.0f, size * 0.008f, 0.0f);
        addShape(here - small, here + small, size * 0.006f);
        if (parent == kNoParent || !shown[static_cast<std::size_t>(parent)]) continue;
        const glm::vec3 there(transforms[static_cast<std::size_t>(parent)][3]);
        addShape(there, here, std::min(glm::length(here - there) * 0.08f, size * 0.02f));
    }
    program_.start();
    setUniform(viewProjection_, camera.viewProjection());
    setUniform(encodesItself_, encodesItself ? 1 : 0);
    vao_.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    setUniform(flatColor_, kFace);
    positions_.store(std::span<const glm::vec3>(triangles_), GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles_.size()));
    setUniform(flatColor_, kEdge);
    positions_.store(std::span<const glm::vec3>(edges_), GL_STREAM_DRAW);
    glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(edges_.size()));
}

}  // namespace walkcycle
