#pragma once

#include <array>
#include <optional>
#include <string>

#include "render/Backdrop.h"
#include "render/ShaderProgram.h"
#include "render/Vao.h"
#include "walkcycle/model/Bounds.h"
#include "walkcycle/render/Camera.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {

// Fills the picture before anything else is drawn: with a soft gradient, a colour, or nothing, and with a
// grid on the ground (the plane y = 0). The grid's steps fit the size of the model that stands on it, and it
// fades out around the model.
class BackgroundRenderer {
public:
    struct Ground {
        const Camera& camera;
        const Bounds& bounds;  // of the model that stands on it
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
