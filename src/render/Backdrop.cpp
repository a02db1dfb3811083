#include "render/Backdrop.h"

namespace walkcycle {

std::string Backdrop::defines() const {
    return std::string(grid ? "#define GRID\n" : "") + (color ? "#define ONE_COLOR\n" : "") +
           (encodesItself ? "#define ENCODES_ITSELF\n" : "");
}

void Backdrop::load(const ShaderProgram& program) const {
    if (color)
        setUniform(program.uniform("color"), *color);
    else
        setUniform(program.uniform("pictureHeight"), pictureHeight);
    if (!grid) return;
    setUniform(program.uniform("groundAt"), grid->groundAt);
    setUniform(program.uniform("fading"), grid->fading);
}

}  // namespace walkcycle
