#include "render/Backdrop.h"

namespace walkcycle {

std::size_t Backdrop::variant() const {
    return (grid ? 1u : 0u) + (color ? 2u : 0u) + (encodesItself ? 4u : 0u);
}

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
