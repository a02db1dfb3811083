#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "render/ShaderProgram.h"
#include "render/Vao.h"
#include "walkcycle/render/AnimatedModel.h"
#include "walkcycle/render/Camera.h"

namespace walkcycle {

// Draws the joints that shownJoints() selects, on top of everything: an octahedron at each joint, and a slim one from
// each parent to its child.
class SkeletonRenderer {
public:
    SkeletonRenderer();

    void render(const AnimatedModel& model, const Camera& camera, bool encodesItself);

private:
    void addShape(const glm::vec3& from, const glm::vec3& to, float width);

    ShaderProgram program_;
    Vbo positions_;
    Vao vao_;
    GLint viewProjection_, flatColor_, encodesItself_;
    std::vector<glm::vec3> triangles_, edges_;
};

// Per node of the skeleton: whether it is a joint, by its type or because a skin refers to it.
std::vector<bool> shownJoints(const Model& model);

}  // namespace walkcycle
