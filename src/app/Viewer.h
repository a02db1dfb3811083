#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/FileWatch.h"
#include "app/OrbitCamera.h"
#include "app/Playback.h"
#include "platform/Window.h"
#include "render/AnimatedModel.h"
#include "render/AnimatedModelRenderer.h"

namespace walkcycle {

struct ViewerSettings {
    std::string file;
    std::string clip;        // --clip as given
    double startTime = 0.0;  // as --time: of the document's timeline, of the clip where one was named
    Playback playback;
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

    void playClip(std::size_t number, double seconds);
    void reload();
    void draw();
    void updateTitle();
    const Animation* clip() const;  // null where nothing moves
    float aspect() const;

    ViewerSettings settings_;
    Window window_;
    AnimatedModelRenderer renderer_;
    std::unique_ptr<AnimatedModel> model_;
    OrbitCamera camera_;
    Playback& playback_;
    FileWatch watch_;
    std::size_t clip_ = 0;
    double mouseX_ = 0.0, mouseY_ = 0.0;
    enum class Drag { None, Orbit, Pan } drag_ = Drag::None;
    bool changed_ = true;  // the picture is not what the window shows
    std::string title_;
};

// The keys and the mouse, as H prints them.
const char* viewerHelp();

}  // namespace walkcycle
