#include "platform/DisplayLoss.h"

#include <dlfcn.h>

namespace walkcycle {
namespace {

void (*lossHandler)() = nullptr;

int onLoss(void*) {
    if (lossHandler) lossHandler();
    return 0;
}

}  // namespace

void whenDisplayIsLost(void (*handler)()) {
    lossHandler = handler;
}

// GLFW loads Xlib at run time. If this library linked Xlib, it would not start on machines that have only Wayland.
void watchDisplay() {
    using Handler = int (*)(void*);
    using SetHandler = Handler (*)(Handler);
    void* xlib = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    if (!xlib) return;
    if (const auto set = reinterpret_cast<SetHandler>(::dlsym(xlib, "XSetIOErrorHandler"))) set(onLoss);
    ::dlclose(xlib);
}

}  // namespace walkcycle
