#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/FileWatch.h"
#include "app/OrbitCamera.h"
#include "walkcycle/platform/Window.h"
#include "walkcycle/render/AnimatedModel.h"
#include "walkcycle/render/AnimatedModelRenderer.h"

namespace walkcycle {

// The choices of the command line for the viewer.
struct ViewerSettings {
    std::string file;                 // the document to show
    std::string clip;                 // the value of --clip, for findClip()
    std::optional<double> startTime;  // the value of --time, for documentTime()
    double speed = 1.0;
    LoopMode loopMode = LoopMode::Loop;
    RenderOptions look;
    bool watch = false;  // load the file again when it changes
    // Loads a file with the options of the command line. Prints its diagnostics, and throws if nothing can be shown.
    std::function<Model(const std::string& file)> load;
};

// The window: plays a model. Keys and mouse change the time, the speed, the look and the camera; viewerHelp() lists
// them.
class Viewer {
public:
    // `first` is the model of settings.file. Throws NoGraphicsDevice.
    Viewer(ViewerSettings settings, Model first);

    // Draws and handles events until the window is closed.
    void run();

private:
    void listen();  // sets the callbacks of the window
    void key(int pressed, int modifiers);
    bool playbackKey(int pressed, int modifiers);  // handles keys of time and speed; false: it is another key
    bool lookKey(int pressed, int modifiers);      // handles keys of the look; false: it is another key
    void drag(double x, double y);

    void playClip(std::size_t number);   // from its start, without moving the camera
    bool load(const std::string& file);  // replaces the model; false: it failed, and the old one stays
    void reload();                       // the same file again, at the same time of the clip
    void open(const std::string& file);  // a file that was dropped on the window
    void draw();
    void updateTitle();
    const Animation* clip() const;  // null if the model has no clips
    bool isMoving() const;          // each picture differs from the one before
    float aspect() const;

    ViewerSettings settings_;
    Window window_;
    AnimatedModelRenderer renderer_;
    std::unique_ptr<AnimatedModel> model_;
    OrbitCamera camera_;
    FileWatch watch_;
    std::size_t clip_ = 0;  // index into animations()
    bool paused_ = false;
    double mouseX_ = 0.0, mouseY_ = 0.0;  // the last position, in window coordinates
    enum class Drag { None, Orbit, Pan } drag_ = Drag::None;
    bool changed_ = true;  // something changed since the last draw()
    std::string title_;    // as the window shows it
};

// The list of keys and mouse movements that the help and the key H print.
const char* viewerHelp();

}  // namespace walkcycle
