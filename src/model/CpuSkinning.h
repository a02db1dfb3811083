#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/Model.h"

namespace walkcycle {

struct NormalTurn;
class SmoothNormals;

// An axis-aligned box in model space. Empty until something is added.
struct Bounds {
    glm::vec3 min{1e30f}, max{-1e30f};

    bool empty() const { return min.x > max.x; }
    void add(const glm::vec3& point);
    void add(const Bounds& other);
    glm::vec3 center() const { return (min + max) * 0.5f; }
    float diagonal() const;
};

// The coefficient of every delta of a run of morphs (`deformers`, innermost first, all of Kind::Morph): the
// result is base + sum of coefficients[i] * delta i, targets counted through the stack in order. NORMALIZED
// layers scale what lies beneath them by (1 - sum of w). Resizes `coefficients`, reusing its memory.
void morphCoefficients(const Model& model, std::span<const Deformer> deformers,
                       std::span<const float> parameters, std::vector<float>& coefficients);

// Whether the normals of an instance are made anew for each shape that its deformers give it. (Not where a bump texture
// needs tangents, which are not made anew.)
bool makesNormals(const Model& model, const MeshInstance& instance);

// Which of an instance's deformers the vertex shader can do: leading morphs, then at most one skin, and normals that turn
// with the vertices. If false, the instance is deformed here and uploaded.
bool shaderCanDeform(const Model& model, const MeshInstance& instance);

// The shader's sum in plain C++: the oracle of the GPU tests, and the source of bounds, poses and baked
// meshes. Results are in model space (world). Keeps its work memory between calls.
class CpuSkinning {
public:
    CpuSkinning();
    CpuSkinning(CpuSkinning&&) noexcept;
    CpuSkinning& operator=(CpuSkinning&&) noexcept;
    ~CpuSkinning();

    // Deforms the instance's positions (one result per MeshData::positions).
    void positions(const Model& model, const MeshInstance& instance,
                   const std::vector<glm::mat4>& modelTransforms, std::span<const float> parameters,
                   std::vector<glm::vec3>& out);

    // Deforms what is drawn: one position and one unit normal per vertex.
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
    std::vector<bool> mirrored_;  // per position: its skins turn inside out
    std::unique_ptr<SmoothNormals> smoothNormals_;
};

// The bounds of everything drawn at one pose.
Bounds bounds(const Model& model, const std::vector<glm::mat4>& modelTransforms,
              std::span<const float> parameters);

// The bounds over a whole clip (null: the rest pose), looked at in `samples` moments evenly spread: what a
// camera must show so that nothing leaves the picture.
Bounds animatedBounds(const Model& model, const Animation* animation, int samples = 16);

}  // namespace walkcycle
