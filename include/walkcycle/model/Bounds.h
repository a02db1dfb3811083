#pragma once

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <walkcycle/Export.h>
#include <walkcycle/model/Model.h>

namespace walkcycle {

// An axis-aligned box in model space. It is empty until something is added.
struct WALKCYCLE_API Bounds {
    glm::vec3 min{1e30f}, max{-1e30f};

    bool empty() const { return min.x > max.x; }
    void add(const glm::vec3& point);
    void add(const Bounds& other);
    glm::vec3 center() const { return (min + max) * 0.5f; }
    float diagonal() const;  // its length; 0 if the box is empty
};

// The bounds of all meshes in one pose, except at nodes that are hidden and that no animation shows.
// `modelTransforms` has one entry per joint and `parameters` one per Model::parameters, as Animator gives
// them.
WALKCYCLE_API Bounds bounds(const Model& model, const std::vector<glm::mat4>& modelTransforms,
                            std::span<const float> parameters);

// The bounds of the model over a whole clip, or at rest if `animation` is null: the union of bounds() at
// `samples` times, at least two, evenly spaced from the start of the clip to its end. Between these times the
// model may leave the box a little.
WALKCYCLE_API Bounds animatedBounds(const Model& model, const Animation* animation, int samples = 16);

}  // namespace walkcycle
