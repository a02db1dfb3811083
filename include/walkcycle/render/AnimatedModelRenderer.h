#pragma once

#include <memory>

#include <walkcycle/Export.h>
#include <walkcycle/render/AnimatedModel.h>
#include <walkcycle/render/Camera.h>
#include <walkcycle/render/RenderOptions.h>

namespace walkcycle {

// Draws animated models. It keeps its shaders and work memory, so use one renderer for all pictures of a
// program. It belongs to the OpenGL context in which it was made.
//
//     AnimatedModelRenderer renderer;
//     renderer.render(model, camera, picture);  // RenderOptions as a fourth argument
class WALKCYCLE_API AnimatedModelRenderer {
public:
    AnimatedModelRenderer();
    ~AnimatedModelRenderer();
    AnimatedModelRenderer(AnimatedModelRenderer&&) noexcept;
    AnimatedModelRenderer& operator=(AnimatedModelRenderer&&) noexcept;

    // One whole picture: background, model, grid, skeleton.
    void render(const AnimatedModel& model, const Camera& camera, const RenderTarget& target,
                const RenderOptions& options = {});

    // The same in steps, for a picture of several models: clear once, then draw each. There is no grid.
    void clear(const RenderTarget& target, const RenderOptions& options = {});
    void draw(const AnimatedModel& model, const Camera& camera, const RenderTarget& target,
              const RenderOptions& options = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
