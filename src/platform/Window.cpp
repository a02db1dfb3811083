#include "walkcycle/platform/Window.h"

#include <utility>

#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "platform/DisplayLoss.h"
#include "walkcycle/platform/NoGraphicsDevice.h"

namespace walkcycle {
namespace {

int windowsOpen = 0;  // GLFW is used on the main thread alone, so this needs no lock

std::string lastError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

void startGlfw() {
    if (windowsOpen == 0 && !glfwInit())
        throw NoGraphicsDevice("no display to open a window on: " + lastError());
    ++windowsOpen;
    watchDisplay();
}

void stopGlfw() {
    if (--windowsOpen == 0) glfwTerminate();
}

GLFWwindow* createWindow(const std::string& title, int width, int height, bool shown, int samples) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS gives no core profile without it
    glfwWindowHint(GLFW_SAMPLES, samples);
    glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, shown ? GLFW_TRUE : GLFW_FALSE);
    return glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
}

MouseButton mouseButton(int button) {
    switch (button) {
        case GLFW_MOUSE_BUTTON_LEFT:
            return MouseButton::Left;
        case GLFW_MOUSE_BUTTON_RIGHT:
            return MouseButton::Right;
        case GLFW_MOUSE_BUTTON_MIDDLE:
            return MouseButton::Middle;
        default:
            return MouseButton::Other;
    }
}

Window& windowOf(GLFWwindow* handle) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

void onKey(GLFWwindow* handle, int key, int, int action, int modifiers) {
    const Window& window = windowOf(handle);
    if (action != GLFW_RELEASE && window.onKey) window.onKey(key, modifiers);
}

void onMouseButton(GLFWwindow* handle, int button, int action, int modifiers) {
    const Window& window = windowOf(handle);
    if (window.onMouseButton) window.onMouseButton(mouseButton(button), action == GLFW_PRESS, modifiers);
}

void onMouseMove(GLFWwindow* handle, double x, double y) {
    const Window& window = windowOf(handle);
    if (window.onMouseMove) window.onMouseMove(x, y);
}

void onScroll(GLFWwindow* handle, double dx, double dy) {
    const Window& window = windowOf(handle);
    if (window.onScroll) window.onScroll(dx, dy);
}

void onResize(GLFWwindow* handle, int width, int height) {
    const Window& window = windowOf(handle);
    if (window.onResize && width > 0 && height > 0) window.onResize({width, height});
}

void onDrop(GLFWwindow* handle, int count, const char** paths) {
    const Window& window = windowOf(handle);
    if (window.onDrop) window.onDrop(std::vector<std::string>(paths, paths + count));
}

}  // namespace

struct Window::Impl {
    GLFWwindow* handle = nullptr;

    Impl(const std::string& title, int width, int height, bool shown) {
        startGlfw();
        handle = createWindow(title, width, height, shown, 4);
        if (!handle) handle = createWindow(title, width, height, shown, 0);
        if (handle) return;
        const std::string reason = lastError();
        stopGlfw();
        throw NoGraphicsDevice("no window with OpenGL 3.3: " + reason);
    }

    ~Impl() {
        glfwDestroyWindow(handle);
        stopGlfw();
    }
};

Window::Window(const std::string& title, int width, int height, Visibility visibility)
    : impl_(std::make_unique<Impl>(title, width, height, visibility == Visibility::Shown)) {
    GLFWwindow* handle = impl_->handle;
    glfwMakeContextCurrent(handle);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(handle, this);
    glfwSetKeyCallback(handle, walkcycle::onKey);
    glfwSetMouseButtonCallback(handle, walkcycle::onMouseButton);
    glfwSetCursorPosCallback(handle, walkcycle::onMouseMove);
    glfwSetScrollCallback(handle, walkcycle::onScroll);
    glfwSetFramebufferSizeCallback(handle, walkcycle::onResize);
    glfwSetDropCallback(handle, walkcycle::onDrop);
}

Window::~Window() = default;

bool Window::shouldClose() const {
    return glfwWindowShouldClose(impl_->handle);
}

void Window::close() {
    glfwSetWindowShouldClose(impl_->handle, GLFW_TRUE);
}

void Window::pollEvents() {
    glfwPollEvents();
}

void Window::waitEvents(double seconds) {
    glfwWaitEventsTimeout(seconds);
}

void Window::swapBuffers() {
    glfwSwapBuffers(impl_->handle);
}

void Window::setVerticalSync(bool on) {
    glfwSwapInterval(on ? 1 : 0);
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(impl_->handle, title.c_str());
}

Window::Size Window::windowSize() const {
    Size size;
    glfwGetWindowSize(impl_->handle, &size.width, &size.height);
    return size;
}

Window::Size Window::framebufferSize() const {
    Size size;
    glfwGetFramebufferSize(impl_->handle, &size.width, &size.height);
    return size;
}

double Window::contentScale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(impl_->handle, &x, &y);
    return x;
}

double Window::time() const {
    return glfwGetTime();
}

std::string Window::description() const {
    const GLubyte* renderer = glGetString(GL_RENDERER);
    const GLubyte* version = glGetString(GL_VERSION);
    return std::string("GLFW window: ") + (renderer ? reinterpret_cast<const char*>(renderer) : "?") +
           ", OpenGL " + (version ? reinterpret_cast<const char*>(version) : "?");
}

}  // namespace walkcycle
