#pragma once

#include <array>
#include <optional>
#include <string>

#include "model/Bounds.h"
#include "render/Backdrop.h"
#include "render/Camera.h"
#include "render/RenderOptions.h"
#include "render/RenderTarget.h"
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
    void render(const RenderOptions& options, bool encodesItself, const Ground* ground,
                const RenderTarget& target);

private:
    struct Program {
        explicit Program(const std::string& defines)
            : program({{"backgroundVertex"}, {"backdrop", "backgroundFragment"}}, defines) {}

        ShaderProgram program;
        Vao noInputs;
    };
    std::array<std::optional<Program>, Backdrop::kVariants> programs_;  // made when first needed
};

}  // namespace walkcycle
