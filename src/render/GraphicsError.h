#pragma once

#include <stdexcept>

namespace walkcycle {

// The graphics driver refuses what OpenGL 3.3 promises: a shader does not compile, or there is no room for a picture.
struct GraphicsError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace walkcycle
