#pragma once

#include "model/CpuSkinning.h"
#include "render/Camera.h"
#include "render/ShaderProgram.h"
#include "render/Vao.h"

namespace walkcycle {

// The ground, y = 0: a grid whose steps fit the size of what stands on it, fading out around it. Drawn with
// blending over what is there, behind what is in front of it.
class GridRenderer {
public:
    GridRenderer();

    void render(const Bounds& bounds, const Camera& camera, bool encodesItself) const;

private:
    ShaderProgram program_;
    Vao noInputs_;
    GLint viewProjection_, center_, radius_, spacing_, lineColor_, encodesItself_;
};

}  // namespace walkcycle
