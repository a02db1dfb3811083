#pragma once

#include <memory>
#include <string>

namespace walkcycle {

// OpenGL 3.3 core without a window or a display, through EGL. Takes the first that works of: each device that
// EGL lists (hardware before software), Mesa's surfaceless platform, the default display. Where EGL_PLATFORM
// is set, what it names comes first.
//
//     HeadlessContext context;                       // current on this thread from here on
//     std::cerr << context.description() << '\n';    // what it took
//
// Throws NoGraphicsDevice.
class HeadlessContext {
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
