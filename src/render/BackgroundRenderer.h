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

// Clears the picture and draws its background: a gradient, a colour or nothing, and a grid on the ground (the plane
// y = 0). The steps of the grid fit the size of the model that stands on it, and the grid fades out around the model.
class BackgroundRenderer {
public:
    struct Ground {
        const Camera& camera;
        const Bounds& bounds;  // of the model that stands on it
    };

    // `encodesItself` is as startDrawingTo() returns it. If `ground` is null, there is no grid.
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
