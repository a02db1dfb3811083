#pragma once

#include <string_view>

namespace walkcycle {

// The text of src/render/shaders/<name>.glsl, which the build puts into the library; empty if there is none.
std::string_view shaderSource(std::string_view name);

}  // namespace walkcycle
