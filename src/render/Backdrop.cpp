#include "render/Backdrop.h"

namespace walkcycle {

void Backdrop::load(const ShaderProgram& program) const {
    setUniform(program.uniform("top"), top);
    setUniform(program.uniform("bottom"), bottom);
    if (!grid) return;
    setUniform(program.uniform("fromPicture"), grid->fromPicture);
    setUniform(program.uniform("center"), grid->center);
    setUniform(program.uniform("radius"), grid->radius);
    setUniform(program.uniform("spacing"), grid->spacing);
    setUniform(program.uniform("lineColor"), grid->lineColor);
}

}  // namespace walkcycle
