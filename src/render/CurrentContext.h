#pragma once

#include <epoxy/gl.h>

#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {

// Throws GraphicsError if no OpenGL context is current on this thread. To be called first by what users construct:
// libepoxy ends the program at the first newer function that is called without a context.
inline void requireContext() {
    if (glGetString(GL_VERSION)) return;
    throw GraphicsError(
        "no OpenGL context is current on this thread: make a HeadlessContext or a Window first, or call its "
        "makeCurrent()");
}

}  // namespace walkcycle
