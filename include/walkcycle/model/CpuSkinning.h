#pragma once

#include <memory>
#include <span>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/model/Model.h>

namespace walkcycle {

// Deforms meshes on the CPU: applies the deformers of an instance in order, as the vertex shader does on the
// GPU. For bounds, exported meshes, and deformers that the shader cannot apply. Results are in model space.
// An object keeps its work memory between calls, so use one for all instances and frames. It is not
// thread-safe.
class WALKCYCLE_API CpuSkinning {
public:
    CpuSkinning();
    ~CpuSkinning();
    CpuSkinning(CpuSkinning&&) noexcept;
    CpuSkinning& operator=(CpuSkinning&&) noexcept;

    // Both functions take the transforms of all joints in model space (one per Skeleton::joints) and the
    // parameters (one per Model::parameters), as Animator gives them. `instance` is one of model.instances.
    //
    // Fills `out` with the deformed positions, one per MeshData::positions.
    void positions(const Model& model, const MeshInstance& instance,
                   const std::vector<glm::mat4>& modelTransforms, std::span<const float> parameters,
                   std::vector<glm::vec3>& out);

    // Fills the outputs with the position and the unit normal of each vertex (MeshData::vertexPositions). The
    // normals of lines are zero.
    void vertices(const Model& model, const MeshInstance& instance,
                  const std::vector<glm::mat4>& modelTransforms, std::span<const float> parameters,
                  std::vector<glm::vec3>& outPositions, std::vector<glm::vec3>& outNormals);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
