#pragma once

#include <memory>
#include <optional>
#include <string>

#include "walkcycle/platform/HeadlessContext.h"
#include "walkcycle/platform/Window.h"

namespace walkcycle {

// An OpenGL context for `render`, which the constructor makes current: without a display ("egl") or through a hidden
// window ("glfw"). "auto" tries egl, then glfw. Throws NoGraphicsDevice.
class Graphics {
public:
    explicit Graphics(const std::string& backend);  // "auto", "egl" or "glfw"

    std::string description() const;  // the device and the driver, in one line

private:
    std::optional<HeadlessContext> headless_;
    std::unique_ptr<Window> window_;
};

}  // namespace walkcycle
