#pragma once

#include <string_view>

namespace walkcycle {

// The text of src/render/shaders/<name>.glsl, which the build put into the library; empty where there is
// none.
std::string_view shaderSource(std::string_view name);

}  // namespace walkcycle
