#pragma once

#include <memory>
#include <string>

#include <walkcycle/Export.h>

namespace walkcycle {

// An OpenGL 3.3 core context without a window or a display, through EGL. The constructor tries each device
// that EGL lists (hardware before software), then Mesa's surfaceless platform, then the default display, and
// takes the first that works. The environment variable EGL_PLATFORM changes the order: with "device" or
// "surfaceless" these come first, with any other value the default display. The context ends with the object.
//
//     HeadlessContext context;                      // current on the calling thread from here on
//     std::cerr << context.description() << '\n';   // the device that it uses
class WALKCYCLE_API HeadlessContext {
public:
    HeadlessContext();  // throws NoGraphicsDevice if none of these works
    ~HeadlessContext();
    HeadlessContext(HeadlessContext&&) noexcept;
    HeadlessContext& operator=(HeadlessContext&&) noexcept;

    // Makes the context current on the calling thread again, for programs with several contexts. Throws
    // NoGraphicsDevice if the device is gone.
    void makeCurrent();

    // The device and the driver, in one line:
    // "EGL device 1 (software), pbuffer: llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 3.3 (Core Profile)
    // Mesa 22.3.6"
    const std::string& description() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
