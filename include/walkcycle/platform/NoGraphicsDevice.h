#pragma once

#include <stdexcept>

#include <walkcycle/Export.h>

namespace walkcycle {

// This machine cannot draw: it has no EGL device, no display or no OpenGL 3.3, or its device is gone. The message is
// one line.
struct WALKCYCLE_API NoGraphicsDevice : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace walkcycle
