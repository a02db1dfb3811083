#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/Model.h"
#include "model/SkinningKernel.h"
#include "model/SmoothNormals.h"

namespace walkcycle {

// An axis-aligned box in model space. Empty until a point is added.
struct Bounds {
    glm::vec3 min{1e30f}, max{-1e30f};

    bool empty() const { return min.x > max.x; }
    void add(const glm::vec3& point);
    void add(const Bounds& other);
    glm::vec3 center() const { return (min + max) * 0.5f; }
    float diagonal() const;
};

// The coefficient of each target of a stack of morphs (`deformers`, innermost first, all of Kind::Morph), so
// that the result is base + sum of coefficients[i] * delta i, with the targets of all morphs in order. A
// NORMALIZED morph scales the coefficients of the morphs before it by (1 - sum of its weights). Resizes
// `coefficients`, and reuses its memory.
void morphCoefficients(const Model& model, std::span<const Deformer> deformers,
                       std::span<const float> parameters, std::vector<float>& coefficients);

// Whether the normals of an instance are computed anew for each shape that its deformers give it. (They are
// not if a bump texture needs tangents, which are not computed anew.)
bool makesNormals(const Model& model, const MeshInstance& instance);

// Whether the vertex shader can apply all deformers of an instance: morphs first, then at most one skin, and
// normals that are transformed with the vertices. If not, the instance is deformed on the CPU and uploaded.
bool shaderCanDeform(const Model& model, const MeshInstance& instance);

// What the vertex shader does, in plain C++: tests compare the GPU with it, and bounds, poses and baked
// meshes come from it. Results are in model space. Keeps its work memory between calls.
class CpuSkinning {
public:
    // Deforms the instance's positions (one result per MeshData::positions).
    void positions(const Model& model, const MeshInstance& instance,
                   const std::vector<glm::mat4>& modelTransforms, std::span<const float> parameters,
                   std::vector<glm::vec3>& out);

    // Deforms the vertices: one position and one unit normal each.
    void vertices(const Model& model, const MeshInstance& instance,
                  const std::vector<glm::mat4>& modelTransforms, std::span<const float> parameters,
                  std::vector<glm::vec3>& outPositions, std::vector<glm::vec3>& outNormals);

private:
    struct Work;
    void deform(Work& work);
    void morph(Work& work, std::span<const Deformer> morphs);
    void skin(Work& work, const Deformer& deformer);
    void makeNormals(Work& work);

    std::vector<glm::mat4> palette_;
    std::vector<float> coefficients_;
    std::vector<NormalTurn> turns_;
    std::vector<glm::vec3> work_;
    std::vector<bool> mirrored_;  // per position: its skins mirror it
    SmoothNormals smoothNormals_;
};

// The bounds of everything drawn at one pose.
Bounds bounds(const Model& model, const std::vector<glm::mat4>& modelTransforms,
              std::span<const float> parameters);

// The bounds over a whole clip (null: of the rest pose), taken at `samples` evenly spaced moments. A camera
// that shows them shows all of the clip.
Bounds animatedBounds(const Model& model, const Animation* animation, int samples = 16);

}  // namespace walkcycle
