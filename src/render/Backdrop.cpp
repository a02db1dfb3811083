#include "render/Backdrop.h"

#include <array>

namespace walkcycle {
namespace {

// The points of a plane before the camera, as backdrop.glsl takes them. Both edges of a line of sight lie on such planes.
std::array<glm::vec3, 3> plane(const glm::mat4& fromPicture, float depth) {
    const auto at = [&](float x, float y) {
        const glm::vec4 point = fromPicture * glm::vec4(x, y, depth, 1.0f);
        return glm::vec3(point) / point.w;
    };
    const glm::vec3 middle = at(0.0f, 0.0f);
    return {middle, at(1.0f, 0.0f) - middle, at(0.0f, 1.0f) - middle};
}

}  // namespace

void Backdrop::load(const ShaderProgram& program, int width, int height) const {
    setUniform(program.uniform("pixelSize"),
               glm::vec2(1.0f / static_cast<float>(width), 1.0f / static_cast<float>(height)));
    setUniform(program.uniform("top"), top);
    setUniform(program.uniform("bottom"), bottom);
    if (!grid) return;
    glUniform3fv(program.uniform("nearest"), 3, &plane(grid->fromPicture, -1.0f)[0].x);
    glUniform3fv(program.uniform("farthest"), 3, &plane(grid->fromPicture, 1.0f)[0].x);
    setUniform(program.uniform("center"), grid->center);
    setUniform(program.uniform("radius"), grid->radius);
    setUniform(program.uniform("spacing"), grid->spacing);
    setUniform(program.uniform("lineColor"), grid->lineColor);
}

}  // namespace walkcycle
