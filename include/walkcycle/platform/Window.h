#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <walkcycle/Export.h>

namespace walkcycle {

// The keys of Window::onKey, with the numbers of GLFW. Letters and digits are not listed: their numbers are the
// upper-case ASCII characters, such as 'A'. (GLFW numbers keys by their place on a US keyboard.)
enum Key : int {
    KeySpace = ' ',
    KeyComma = ',',
    KeyMinus = '-',
    KeyPeriod = '.',
    KeyEqual = '=',
    KeyEscape = 256,
    KeyEnter = 257,
    KeyTab = 258,
    KeyBackspace = 259,
    KeyDelete = 261,
    KeyRight = 262,
    KeyLeft = 263,
    KeyDown = 264,
    KeyUp = 265,
    KeyPageUp = 266,
    KeyPageDown = 267,
    KeyHome = 268,
    KeyEnd = 269,
    KeyF1 = 290
};
// Bits of the argument `modifiers` of Window's callbacks.
enum KeyModifier : int { ModShift = 1, ModControl = 2, ModAlt = 4, ModSuper = 8 };
// Other: any button beyond the third.
enum class MouseButton { Left, Right, Middle, Other };

// A window with an OpenGL 3.3 core context, which the constructor makes current. For the main thread only, as GLFW is.
// Two units of length: mouse positions count in window coordinates, from the upper left corner (windowSize), pictures
// in pixels (framebufferSize). On a high-DPI screen, a window coordinate may span several pixels.
//
//     Window window("Walkcycle", 1280, 720);
//     window.onKey = [&](int key, int modifiers) { if (key == KeySpace) paused = !paused; };
//     while (!window.shouldClose()) {
//         window.pollEvents();
//         const Window::Size size = window.framebufferSize();
//         renderer.render(model, camera, RenderTarget{0, size.width, size.height}, options);
//         window.swapBuffers();
//     }
class WALKCYCLE_API Window {
public:
    struct Size {
        int width = 0;
        int height = 0;
    };
    enum class Visibility { Shown, Hidden };  // a hidden window gives its OpenGL context only

    // Width and height are in window coordinates. Throws NoGraphicsDevice if there is no display or no OpenGL 3.3.
    Window(const std::string& title, int width, int height, Visibility visibility = Visibility::Shown);
    ~Window();
    Window(Window&&) = delete;

    // Callbacks, which pollEvents() and waitEvents() call. Each may be left empty.
    std::function<void(int key, int modifiers)> onKey;  // at a press and at each repeat; `key` as in enum Key
    std::function<void(MouseButton button, bool pressed, int modifiers)> onMouseButton;  // press and release
    std::function<void(double x, double y)> onMouseMove;  // the new position, in window coordinates, y down
    std::function<void(double dx, double dy)> onScroll;   // in steps of the wheel; dy > 0: away from the user
    std::function<void(Size framebuffer)> onResize;  // in pixels; draw in it, for it also runs during a drag
    std::function<void(const std::vector<std::string>& paths)> onDrop;  // of files dropped on the window

    bool shouldClose() const;         // the user has closed the window, or close() was called
    void close();                     // asks the loop to end; the window closes when the object is deleted
    void pollEvents();                // calls the callbacks of all events that have arrived
    void waitEvents(double seconds);  // the same, after a wait for an event of at most `seconds`
    void swapBuffers();               // shows the picture that was drawn to framebuffer 0
    void setVerticalSync(bool on);    // on (the default): swapBuffers() waits for the screen
    void setTitle(const std::string& title);

    Size windowSize() const;       // in window coordinates
    Size framebufferSize() const;  // in pixels; 0 while the window is minimised
    double contentScale() const;   // how much to enlarge text: 1 on an ordinary screen, 2 on a high-DPI one
    double time() const;           // seconds since the first window was made
    std::string description() const;  // the driver, in one line

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
