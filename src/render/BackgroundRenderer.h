#pragma once

#include <optional>

#include "model/CpuSkinning.h"
#include "render/Camera.h"
#include "render/RenderOptions.h"
#include "render/ShaderProgram.h"
#include "render/Vao.h"

namespace walkcycle {

// Fills the picture before anything is drawn: with a soft gradient, a colour, or nothing; and with the ground, a grid
// in the plane y = 0 whose steps fit the size of what stands on it, fading out around it.
class BackgroundRenderer {
public:
    struct Ground {
        const Camera& camera;
        const Bounds& bounds;  // of what stands on it
    };

    // Without `ground`: no grid.
    void render(const RenderOptions& options, bool encodesItself, const Ground* ground);

private:
    class Backdrop {
    public:
        explicit Backdrop(const char* defines)
            : program_({{"backgroundVertex"}, {"backgroundFragment"}}, defines) {}

        void draw(const RenderOptions& options, bool encodesItself, const Ground* ground) const;

    private:
        void loadGround(const Ground& ground, bool encodesItself) const;

        ShaderProgram program_;
        Vao noInputs_;
    };
    std::optional<Backdrop> plain_, withGrid_;  // made when first needed
};

}  // namespace walkcycle
