#pragma once

#include <memory>
#include <optional>
#include <string>

#include "walkcycle/platform/HeadlessContext.h"
#include "walkcycle/platform/Window.h"

namespace walkcycle {

// An OpenGL context to draw pictures with: without a display (EGL) or through a hidden window (GLFW). "auto"
// takes the first of the two that works. Throws NoGraphicsDevice.
class Graphics {
public:
    explicit Graphics(const std::string& backend);  // "auto", "egl" or "glfw"

    std::string description() const;

private:
    std::optional<HeadlessContext> headless_;
    std::unique_ptr<Window> window_;
};

}  // namespace walkcycle
