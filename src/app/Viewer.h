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

struct ViewerSettings {
    std::string file;
    std::string clip;                 // --clip as given
    std::optional<double> startTime;  // --time: of the document's timeline, of the clip where one was named
    double speed = 1.0;
    LoopMode loopMode = LoopMode::Loop;
    RenderOptions look;
    bool watch = false;
    std::function<Model(const std::string& file)> load;  // says itself what is wrong; throws
};

// The window: plays a model, and lets a person look at it from all sides.
class Viewer {
public:
    Viewer(ViewerSettings settings, Model first);

    void run();  // until the window is closed

private:
    void listen();
    void key(int pressed, int modifiers);
    bool playbackKey(int pressed, int modifiers);  // these two: whether it was theirs
    bool lookKey(int pressed, int modifiers);
    void drag(double x, double y);

    void playClip(std::size_t number);
    bool load(const std::string& file);  // false: the model stays as it was
    void reload();
    void open(const std::string& file);
    void draw();
    void updateTitle();
    const Animation* clip() const;  // null where nothing moves
    bool isMoving() const;
    float aspect() const;

    ViewerSettings settings_;
    Window window_;
    AnimatedModelRenderer renderer_;
    std::unique_ptr<AnimatedModel> model_;
    OrbitCamera camera_;
    FileWatch watch_;
    std::size_t clip_ = 0;
    bool paused_ = false;
    double mouseX_ = 0.0, mouseY_ = 0.0;
    enum class Drag { None, Orbit, Pan } drag_ = Drag::None;
    bool changed_ = true;  // the picture is not what the window shows
    std::string title_;
};

// The keys and the mouse, as H prints them.
const char* viewerHelp();

}  // namespace walkcycle
