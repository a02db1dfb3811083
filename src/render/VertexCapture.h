#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "render/AnimatedModelShader.h"
#include "render/InstanceStates.h"

namespace walkcycle {

// Reads back what the vertex shader makes of an instance's vertices: the same text that draws them, run with
// transform feedback and without drawing. Tests compare it with CpuSkinning.
class VertexCapture {
public:
    struct Vertices {
        std::vector<glm::vec3> positions;  // in model space, one per vertex
        std::vector<glm::vec3> normals;
    };
    Vertices capture(const AnimatedModel& model, std::size_t instance);

private:
    InstanceStates states_;
};

}  // namespace walkcycle
