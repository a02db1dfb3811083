#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <walkcycle/Export.h>
#include <walkcycle/animation/JointRows.h>
#include <walkcycle/render/AnimatedModel.h>
#include <walkcycle/render/Camera.h>
#include <walkcycle/render/RenderOptions.h>

namespace walkcycle {

// Draws many walkers of one model, each with its own position and time, with one OpenGL call per part of the
// model. The palettes of all walkers lie in one texture, and the shader computes the start of a walker's palette from
// the walker's number (gl_InstanceID).
//
//     std::vector<JointRows> palettes;  // each walker's own struct has its seconds and its placement (a glm::mat4)
//     for (const Walker& walker : walkers) {
//         model.setTime(walker.seconds);
//         appendPalette(model, palettes);
//         place(std::span(palettes).last(jointsPerWalker(model.model())), walker.placement);
//     }
//     renderer.clear(picture);  // an AnimatedModelRenderer's
//     crowd.draw(model, palettes, camera, picture);
//
// For a model of a single skinned mesh, CrowdPoser computes the palettes four times as fast (docs/performance.md).
// All walkers share the model's materials, lights and morph weights. Transparent walkers are not sorted by
// distance. A CrowdRenderer keeps its shaders and work memory, and belongs to the OpenGL context in which it was made.
class WALKCYCLE_API CrowdRenderer {
public:
    CrowdRenderer();
    // `maxTexels`: the size of the largest texture buffer to use, three texels per matrix; the default is the driver's
    // limit. If the palettes do not fit into one buffer, the walkers are drawn in several calls.
    explicit CrowdRenderer(std::size_t maxTexels);
    ~CrowdRenderer();
    CrowdRenderer(CrowdRenderer&&) noexcept;
    CrowdRenderer& operator=(CrowdRenderer&&) noexcept;

    // Draws the crowd over the target's present colours. `palettes`: walker after walker,
    // jointsPerWalker(model.model()) matrices each, from mesh space to model space. Throws GraphicsError if one palette
    // is larger than a texture buffer, or if a mesh must be deformed on the CPU: a deformer follows its skin, or its
    // normals are computed from the deformed faces because the file has none.
    void draw(const AnimatedModel& model, std::span<const JointRows> palettes, const Camera& camera,
              const RenderTarget& target, const RenderOptions& options = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The number of matrices in a walker's palette: for each mesh instance one per joint of its skin or, without a skin,
// a single one (the model transform of its node).
WALKCYCLE_API std::size_t jointsPerWalker(const Model& model);

// Appends the palette of the model's present pose to `palettes`: jointsPerWalker(model.model()) matrices, in the order
// of Model::instances.
WALKCYCLE_API void appendPalette(const AnimatedModel& model, std::vector<JointRows>& palettes);

}  // namespace walkcycle
