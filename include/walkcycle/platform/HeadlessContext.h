#pragma once

#include <memory>
#include <string>

#include <walkcycle/Export.h>

namespace walkcycle {

// An OpenGL 3.3 core context without a window or a display, through EGL. The constructor tries each device
// that EGL lists (hardware before software), then Mesa's surfaceless platform, then the default display, and
// takes the first that works. If the environment variable EGL_PLATFORM names one of these, that one is tried
// first.
//
//     HeadlessContext context;                       // current on this thread from here on
//     std::cerr << context.description() << '\n';    // which device it uses
//
// Throws NoGraphicsDevice.
class WALKCYCLE_API HeadlessContext {
public:
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(HeadlessContext&&) noexcept;
    HeadlessContext& operator=(HeadlessContext&&) noexcept;

    void makeCurrent();

    // "EGL device 1 (software), pbuffer: llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 3.3 (Core Profile)
    // Mesa 22.3.6"
    const std::string& description() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
