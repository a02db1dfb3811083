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
// model. The palettes of all walkers lie in one texture, and the number of the walker (gl_InstanceID) says
// where its palette begins.
//
//     std::vector<JointRows> palettes;
//     for (const Walker& walker : walkers) {
//         model.setTime(walker.seconds);
//         appendPalette(model, palettes);
//         place(std::span(palettes).last(jointsPerWalker(model.model())), walker.placement);
//     }
//     renderer.clear(picture);  // an AnimatedModelRenderer's
//     crowd.draw(model, palettes, camera, picture);
//
// A CrowdPoser makes the palettes of a model with a single skinned mesh four times as fast (docs/performance.md). All
// walkers share the model's materials, lights and morph weights. Transparent walkers are not sorted by
// distance. Keeps its shaders and work memory, and belongs to the OpenGL context in which it was made.
class WALKCYCLE_API CrowdRenderer {
public:
    CrowdRenderer();
    // `maxTexels`: the largest texture buffer; if the palettes do not fit into one, they are drawn in several
    // calls.
    explicit CrowdRenderer(std::size_t maxTexels);
    ~CrowdRenderer();
    CrowdRenderer(CrowdRenderer&&) noexcept;
    CrowdRenderer& operator=(CrowdRenderer&&) noexcept;

    // `palettes`: walker after walker, jointsPerWalker(model) matrices each. Throws GraphicsError if one
    // palette exceeds a texture buffer, or the shader cannot deform the model.
    void draw(const AnimatedModel& model, std::span<const JointRows> palettes, const Camera& camera,
              const RenderTarget& target, const RenderOptions& options = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The number of matrices in a walker's palette: for each mesh instance those of its skin, or, without a skin,
// one that places it.
WALKCYCLE_API std::size_t jointsPerWalker(const Model& model);

// Appends the palette of the model's present pose.
WALKCYCLE_API void appendPalette(const AnimatedModel& model, std::vector<JointRows>& palettes);

}  // namespace walkcycle
