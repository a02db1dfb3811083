#pragma once

#include <memory>

#include <walkcycle/Export.h>
#include <walkcycle/render/AnimatedModel.h>
#include <walkcycle/render/Camera.h>
#include <walkcycle/render/RenderOptions.h>

namespace walkcycle {

// Draws animated models. It keeps its shaders and work memory, so use one renderer for all pictures of a
// program. It belongs to the OpenGL context in which it was made. Each draw sets the OpenGL state that it relies on.
// All functions throw GraphicsError if the driver refuses a shader.
//
//     AnimatedModelRenderer renderer;
//     renderer.render(model, camera, picture);  // RenderOptions can be the fourth argument
class WALKCYCLE_API AnimatedModelRenderer {
public:
    AnimatedModelRenderer();
    ~AnimatedModelRenderer();
    AnimatedModelRenderer(AnimatedModelRenderer&&) noexcept;
    AnimatedModelRenderer& operator=(AnimatedModelRenderer&&) noexcept;

    // Draws a whole picture of one model in its present pose: the background with its grid, the model and, if the
    // options ask for them, edges and skeleton.
    void render(const AnimatedModel& model, const Camera& camera, const RenderTarget& target,
                const RenderOptions& options = {});

    // The same in two steps, for a picture of several models: clear() once, then draw() for each model.
    //
    // Clears colours and depths, and draws the background. There is no grid, since its size would depend on one model.
    void clear(const RenderTarget& target, const RenderOptions& options = {});
    // Draws a model over the target's present colours, in front of or behind the models drawn before.
    void draw(const AnimatedModel& model, const Camera& camera, const RenderTarget& target,
              const RenderOptions& options = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
