#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <walkcycle/Export.h>

namespace walkcycle {

// Keys as GLFW numbers them; letters and digits are their upper-case ASCII characters.
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
enum KeyModifier : int { ModShift = 1, ModControl = 2, ModAlt = 4, ModSuper = 8 };
enum class MouseButton { Left, Right, Middle, Other };

// A window with an OpenGL 3.3 core context, which the constructor makes current on the calling thread. Every
// callback may be left empty. Mouse positions are in window coordinates (windowSize); pictures are drawn in
// pixels (framebufferSize), which are smaller on a high-DPI screen.
//
//     Window window("Walkcycle", 1280, 720);
//     window.onKey = [&](int key, int modifiers) { if (key == KeySpace) paused = !paused; };
//     while (!window.shouldClose()) {
//         window.pollEvents();
//         renderer.render(model, camera, RenderTarget{0, window.framebufferSize().width, ...}, options);
//         window.swapBuffers();
//     }
//
// Throws NoGraphicsDevice if there is no display or no OpenGL 3.3.
class WALKCYCLE_API Window {
public:
    struct Size {
        int width = 0;
        int height = 0;
    };
    enum class Visibility { Shown, Hidden };

    Window(const std::string& title, int width, int height, Visibility visibility = Visibility::Shown);
    ~Window();
    Window(Window&&) = delete;

    std::function<void(int key, int modifiers)> onKey;  // pressed or repeated
    std::function<void(MouseButton button, bool pressed, int modifiers)> onMouseButton;
    std::function<void(double x, double y)> onMouseMove;
    std::function<void(double dx, double dy)> onScroll;
    std::function<void(Size framebuffer)> onResize;  // also while the user drags the border: draw in it
    std::function<void(const std::vector<std::string>& paths)> onDrop;

    bool shouldClose() const;
    void close();
    void pollEvents();
    void waitEvents(double seconds);  // sleeps until an event arrives, at most for this long
    void swapBuffers();
    void setVerticalSync(bool on);
    void setTitle(const std::string& title);

    Size windowSize() const;
    Size framebufferSize() const;
    double contentScale() const;  // 1 on an ordinary screen, 2 on a high-DPI one
    double time() const;          // seconds since the first window was made
    std::string description() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
