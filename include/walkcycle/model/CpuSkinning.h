#pragma once

#include <memory>
#include <span>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/model/Model.h>

namespace walkcycle {

// What the vertex shader does, in plain C++: tests compare the GPU with it, and bounds, poses and baked
// meshes come from it. Results are in model space. It keeps its work memory between calls, so use one for all
// instances and all frames.
class WALKCYCLE_API CpuSkinning {
public:
    CpuSkinning();
    ~CpuSkinning();
    CpuSkinning(CpuSkinning&&) noexcept;
    CpuSkinning& operator=(CpuSkinning&&) noexcept;

    // Deforms the instance's positions (one result per MeshData::positions).
    void positions(const Model& model, const MeshInstance& instance,
                   const std::vector<glm::mat4>& modelTransforms, std::span<const float> parameters,
                   std::vector<glm::vec3>& out);

    // Deforms the vertices: one position and one unit normal each.
    void vertices(const Model& model, const MeshInstance& instance,
                  const std::vector<glm::mat4>& modelTransforms, std::span<const float> parameters,
                  std::vector<glm::vec3>& outPositions, std::vector<glm::vec3>& outNormals);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
