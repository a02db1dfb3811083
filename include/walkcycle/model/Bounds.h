#pragma once

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <walkcycle/Export.h>
#include <walkcycle/model/Model.h>

namespace walkcycle {

// An axis-aligned box in model space. Empty until something is added.
struct WALKCYCLE_API Bounds {
    glm::vec3 min{1e30f}, max{-1e30f};

    bool empty() const { return min.x > max.x; }
    void add(const glm::vec3& point);
    void add(const Bounds& other);
    glm::vec3 center() const { return (min + max) * 0.5f; }
    float diagonal() const;
};

// The bounds of everything that is drawn in one pose.
WALKCYCLE_API Bounds bounds(const Model& model, const std::vector<glm::mat4>& modelTransforms,
                            std::span<const float> parameters);

// The bounds that the model stays within during a whole clip (null: in the rest pose), taken from `samples` moments at
// equal distances.
WALKCYCLE_API Bounds animatedBounds(const Model& model, const Animation* animation, int samples = 16);

}  // namespace walkcycle
