#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "animation/JointRows.h"
#include "render/AnimatedModel.h"
#include "render/Camera.h"
#include "render/RenderOptions.h"
#include "render/RenderTarget.h"

namespace walkcycle {

// Draws many walkers of one model, each at a place and a time of its own, with one call for each part of the model: all
// their palettes lie in one texture, and the instance's number says where a walker's begins.
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
// A CrowdPoser makes the palettes of a model with a single skinned mesh four times as fast (docs/performance.md).
// Materials, lights and morph weights are the model's, the same for all. Walkers that show through are not sorted. Keeps
// its shaders and work memory, and belongs to the OpenGL context that it was made in.
class CrowdRenderer {
public:
    CrowdRenderer();
    // `maxTexels`: how large a texture buffer may be; more walkers than fit are drawn in several calls.
    explicit CrowdRenderer(std::size_t maxTexels);
    ~CrowdRenderer();
    CrowdRenderer(CrowdRenderer&&) noexcept;
    CrowdRenderer& operator=(CrowdRenderer&&) noexcept;

    // `palettes`: walker after walker, each of jointsPerWalker(model). Throws GraphicsError where that is more than a
    // texture buffer holds, or the shader cannot deform the model.
    void draw(const AnimatedModel& model, std::span<const JointRows> palettes, const Camera& camera,
              const RenderTarget& target, const RenderOptions& options = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// How many matrices a walker's palette has: for each mesh instance of the model those of its skin, or one that places it
// where it has none.
std::size_t jointsPerWalker(const Model& model);

// Adds the palette of the pose that the model has now.
void appendPalette(const AnimatedModel& model, std::vector<JointRows>& palettes);

}  // namespace walkcycle
