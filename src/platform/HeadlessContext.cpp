#include "walkcycle/platform/HeadlessContext.h"

#include <cstddef>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "walkcycle/platform/NoGraphicsDevice.h"

namespace walkcycle {
namespace {

// A display that may give a context, and its name for description().
struct Candidate {
    EGLDisplay display = EGL_NO_DISPLAY;
    std::string name;
};

// Whether a list of extensions, with spaces between them, has this name.
bool lists(const char* extensions, std::string_view name) {
    const std::string_view all = extensions ? extensions : "";
    for (std::size_t at = all.find(name); at != all.npos; at = all.find(name, at + 1)) {
        const bool begins = at == 0 || all[at - 1] == ' ';
        const bool ends = at + name.size() == all.size() || all[at + name.size()] == ' ';
        if (begins && ends) return true;
    }
    return false;
}

// Epoxy's own eglGetPlatformDisplay queries the version of a display first, and aborts if there is no display
// yet.
EGLDisplay platformDisplay(EGLenum platform, void* native) {
    static const auto get =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    return get ? get(platform, native, nullptr) : EGL_NO_DISPLAY;
}

// Every device that EGL lists, hardware before software.
std::vector<Candidate> deviceDisplays(const char* clientExtensions) {
    std::vector<Candidate> hardware, software;
    if (!lists(clientExtensions, "EGL_EXT_platform_device")) return hardware;
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto text =
        reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
    EGLint count = 0;
    if (!query || !query(0, nullptr, &count) || count <= 0) return hardware;
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (!query(count, devices.data(), &count)) return hardware;
    devices.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const bool soft = text && lists(text(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
        const EGLDisplay display = platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i]);
        const std::string name = "EGL device " + std::to_string(i) + (soft ? " (software)" : "");
        if (display != EGL_NO_DISPLAY) (soft ? software : hardware).push_back({display, name});
    }
    hardware.insert(hardware.end(), software.begin(), software.end());
    return hardware;
}

std::vector<Candidate> surfacelessDisplay(const char* clientExtensions) {
    if (!lists(clientExtensions, "EGL_MESA_platform_surfaceless")) return {};
    const EGLDisplay display = platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY) return {};
    return {{display, "EGL surfaceless platform"}};
}

std::vector<Candidate> defaultDisplay() {
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY) return {};
    return {{display, "EGL default display"}};
}

// The ways to get a display, in the order in which they are tried. Each takes time, so a later way is not even listed
// before the earlier ones have failed.
using Way = std::vector<Candidate> (*)(const char*);
std::vector<Way> waysToADisplay() {
    const Way device = deviceDisplays;
    const Way surfaceless = surfacelessDisplay;
    const Way standard = [](const char*) { return defaultDisplay(); };
    const char* variable = std::getenv("EGL_PLATFORM");
    const std::string_view preferred = variable ? variable : "";
    if (preferred.empty() || preferred == "device") return {device, surfaceless, standard};
    if (preferred == "surfaceless") return {surfaceless, device, standard};
    return {standard, device, surfaceless};
}

// All contexts of a process on one device share its display, and eglTerminate ends the display for all of them. So only
// the last context calls it.
std::mutex displayMutex;
std::map<EGLDisplay, int> displayUsers;

bool initialize(EGLDisplay display) {
    const std::lock_guard lock(displayMutex);
    if (!eglInitialize(display, nullptr, nullptr)) return false;
    ++displayUsers[display];
    return true;
}

void release(EGLDisplay display) {
    const std::lock_guard lock(displayMutex);
    if (--displayUsers[display] > 0) return;
    displayUsers.erase(display);
    eglTerminate(display);
}

const EGLint kContextAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};

EGLConfig chooseConfig(EGLDisplay display, EGLint surfaceType) {
    const EGLint attributes[] = {EGL_SURFACE_TYPE, surfaceType, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                 EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    return eglChooseConfig(display, attributes, &config, 1, &count) && count > 0 ? config : nullptr;
}

std::string glText(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "?";
}

}  // namespace

struct HeadlessContext::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    EGLSurface surface = EGL_NO_SURFACE;
    std::string description;

    ~Impl() {
        if (display == EGL_NO_DISPLAY) return;
        if (context != EGL_NO_CONTEXT && eglGetCurrentContext() == context) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        release(display);
    }

    bool makeCurrent() const { return eglMakeCurrent(display, surface, surface, context); }

    // Pictures are drawn into framebuffers of our own. The pbuffer is for drivers that require a surface.
    bool createContext() {
        EGLConfig config = chooseConfig(display, EGL_PBUFFER_BIT);
        const bool pbuffer = config != nullptr;
        if (!pbuffer) config = chooseConfig(display, 0);
        if (!config || !eglBindAPI(EGL_OPENGL_API)) return false;
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, kContextAttributes);
        if (context == EGL_NO_CONTEXT) return false;
        const EGLint onePixel[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        if (pbuffer) surface = eglCreatePbufferSurface(display, config, onePixel);
        return makeCurrent();
    }

    // Null if the display gives no OpenGL 3.3 context.
    static std::unique_ptr<Impl> on(const Candidate& candidate) {
        if (!initialize(candidate.display)) return nullptr;
        auto impl = std::make_unique<Impl>();
        impl->display = candidate.display;
        if (!impl->createContext()) return nullptr;
        impl->description = candidate.name +
                            (impl->surface != EGL_NO_SURFACE ? ", pbuffer: " : ", no surface: ") +
                            glText(GL_RENDERER) + ", OpenGL " + glText(GL_VERSION);
        return impl;
    }
};

HeadlessContext::HeadlessContext() {
    const char* clientExtensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    for (const Way way : waysToADisplay()) {
        for (const Candidate& candidate : way(clientExtensions)) {
            impl_ = Impl::on(candidate);
            if (impl_) return;
        }
    }
    throw NoGraphicsDevice(
        "no graphics device: EGL gives no OpenGL 3.3 context (on Debian, install libegl1 and "
        "libgl1-mesa-dri)");
}

HeadlessContext::~HeadlessContext() = default;
HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;

void HeadlessContext::makeCurrent() {
    if (!impl_->makeCurrent()) throw NoGraphicsDevice("the graphics device is gone: eglMakeCurrent failed");
}

const std::string& HeadlessContext::description() const {
    return impl_->description;
}

}  // namespace walkcycle
