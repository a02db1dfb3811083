#pragma once

#include "render/RenderOptions.h"
#include "render/ShaderProgram.h"
#include "render/Vao.h"

namespace walkcycle {

// Fills the picture before anything is drawn: with a soft gradient, a colour, or nothing.
class BackgroundRenderer {
public:
    BackgroundRenderer();

    void render(const RenderOptions& options, bool encodesItself) const;

private:
    ShaderProgram program_;
    Vao noInputs_;
    GLint top_, bottom_, encodesItself_;
};

}  // namespace walkcycle
