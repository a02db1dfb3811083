#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "render/AnimatedModelShader.h"
#include "render/InstanceStates.h"

namespace walkcycle {

// Reads back the vertices that animatedModelVertex.glsl computes for an instance, through transform feedback and
// without drawing. For tests, which compare them with those of CpuSkinning.
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
