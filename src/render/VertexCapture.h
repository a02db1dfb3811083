#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "render/AnimatedModelShader.h"
#include "render/InstanceStates.h"

namespace walkcycle {

// Reads back the vertices that the vertex shader computes for an instance, through transform feedback and
// without drawing. The shader is the one that draws. Tests compare its result with CpuSkinning's.
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
