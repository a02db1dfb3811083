#pragma once

#include <memory>

#include "render/AnimatedModel.h"
#include "render/Camera.h"
#include "render/RenderOptions.h"
#include "render/RenderTarget.h"
#include "render/ScreenArea.h"

namespace walkcycle {

// Draws animated models. Keeps its shaders and work memory, so one renderer should draw all pictures of a
// program; belongs to the OpenGL context that it was made in.
//
//     AnimatedModelRenderer renderer;
//     renderer.render(model, camera, picture);  // RenderOptions as a fourth argument
class AnimatedModelRenderer {
public:
    AnimatedModelRenderer();
    ~AnimatedModelRenderer();
    AnimatedModelRenderer(AnimatedModelRenderer&&) noexcept;
    AnimatedModelRenderer& operator=(AnimatedModelRenderer&&) noexcept;

    // One whole picture: background, model, grid, skeleton.
    void render(const AnimatedModel& model, const Camera& camera, const RenderTarget& target,
                const RenderOptions& options = {});

    // Outside of this area the last picture by render() shows the background alone, which Framebuffer::read() can use.
    ScreenArea drawnArea() const;

    // The same in steps, for pictures with several models: clear once, then draw each. Without the grid.
    void clear(const RenderTarget& target, const RenderOptions& options = {});
    void draw(const AnimatedModel& model, const Camera& camera, const RenderTarget& target,
              const RenderOptions& options = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
