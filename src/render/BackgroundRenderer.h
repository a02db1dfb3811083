#pragma once

#include <optional>

#include "render/RenderOptions.h"
#include "render/ShaderProgram.h"
#include "render/Vao.h"

namespace walkcycle {

// Fills the picture before anything is drawn: with a soft gradient, a colour, or nothing.
class BackgroundRenderer {
public:
    void render(const RenderOptions& options, bool encodesItself);

private:
    struct Gradient {
        ShaderProgram program{{{"backgroundVertex"}, {"backgroundFragment"}}};
        Vao noInputs;
    };
    std::optional<Gradient> gradient_;  // made when first needed
};

}  // namespace walkcycle
