#include "app/Viewer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/Clips.h"
#include "app/FormatNumber.h"
#include "app/LoadArguments.h"
#include "app/Messages.h"
#include "loaders/Diagnostics.h"

namespace walkcycle {
namespace {

constexpr int kWidth = 1280, kHeight = 720;
constexpr double kSpeedStep = 1.25;
constexpr double kSecondsPerFrame = 1.0 / 60.0;
constexpr double kLongestFrame = 0.25;  // after a pause of the system, go on rather than jump

std::string baseName(const std::string& file) {
    return std::filesystem::path(file).filename().string();
}

}  // namespace

const char* viewerHelp() {
    return "left drag: orbit    right drag or shift + left drag: pan    wheel: zoom    Enter: the first view "
           "again\n"
           "Space: pause    , and .: a step back or on    - and =: slower or faster    Home: the clip's "
           "start\n"
           "Tab: next clip    Shift+A: skeleton    E: wireframe    G: ground    H: this help    Q or Escape: "
           "quit\n";
}

Viewer::Viewer(ViewerSettings settings, Model first)
    : settings_(std::move(settings)),
      window_("Walkcycle", kWidth, kHeight),
      model_(std::make_unique<AnimatedModel>(std::move(first))),
      playback_(settings_.playback),
      watch_(settings_.file) {
    if (const Animation* named = findClip(model_->model(), settings_.clip)) {
        const double start = documentTime(settings_.startTime, named, settings_.clip);
        playClip(static_cast<std::size_t>(named - model_->animations().data()), start - named->startSeconds);
    }
    camera_.frame(model_->bounds(), aspect());
    listen();
}

float Viewer::aspect() const {
    const Window::Size size = window_.framebufferSize();
    return size.height > 0 ? static_cast<float>(size.width) / static_cast<float>(size.height) : 1.0f;
}

const Animation* Viewer::clip() const {
    return clip_ < model_->animations().size() ? &model_->animations()[clip_] : nullptr;
}

void Viewer::playClip(std::size_t number, double seconds) {
    clip_ = number;
    if (clip()) model_->doAnimation(*clip());
    playback_.start(clip() ? clip()->lengthInSeconds() : 0.0, seconds);
    camera_.keep(model_->bounds());
    changed_ = true;
}

// The new file in the old place: same view, same clip, same moment. A file that does not load leaves all as it is.
void Viewer::reload() {
    const std::string clipName = clip() ? clip()->name : "";
    try {
        model_ = std::make_unique<AnimatedModel>(settings_.load(settings_.file));
    } catch (const LoadError&) {  // said already
        return printNote("kept the model as it was");
    } catch (const StrictFailure&) {
        return printNote("kept the model as it was");
    } catch (const std::exception& error) {
        return printError("kept the model as it was: " + std::string(error.what()));
    }
    std::size_t number = 0;
    for (std::size_t i = 0; i < model_->animations().size(); ++i)
        if (model_->animations()[i].name == clipName) number = i;
    playClip(number, playback_.time());
    printNote("loaded " + settings_.file + " again");
}

void Viewer::listen() {
    window_.onKey = [this](int pressed, int modifiers) { key(pressed, modifiers); };
    window_.onMouseButton = [this](MouseButton button, bool pressed, int modifiers) {
        const bool pan =
            button == MouseButton::Right || button == MouseButton::Middle || (modifiers & ModShift);
        drag_ = !pressed ? Drag::None : pan ? Drag::Pan : Drag::Orbit;
    };
    window_.onMouseMove = [this](double x, double y) { drag(x, y); };
    window_.onScroll = [this](double, double steps) {
        camera_.zoom(static_cast<float>(steps));
        changed_ = true;
    };
    window_.onResize = [this](Window::Size) { draw(); };
    window_.onDrop = [this](const std::vector<std::string>& paths) {
        settings_.file = paths.front();
        watch_ = FileWatch(settings_.file);
        reload();
        camera_.frame(model_->bounds(), aspect());
    };
}

void Viewer::drag(double x, double y) {
    const double height = std::max(1, window_.windowSize().height);
    const float dx = static_cast<float>((x - mouseX_) / height),
                dy = static_cast<float>((y - mouseY_) / height);
    mouseX_ = x;
    mouseY_ = y;
    if (drag_ == Drag::None) return;
    if (drag_ == Drag::Orbit)
        camera_.orbit(dx, dy);
    else
        camera_.pan(dx, dy);
    changed_ = true;
}

void Viewer::key(int pressed, int modifiers) {
    changed_ = true;
    if (playbackKey(pressed, modifiers) || lookKey(pressed, modifiers)) return;
    if (pressed == KeyEnter) camera_.frame(model_->bounds(), aspect());
    if (pressed == 'H') printNote(std::string("the window's keys\n") + viewerHelp());
    if (pressed == 'Q' || pressed == KeyEscape) window_.close();
}

bool Viewer::playbackKey(int pressed, int modifiers) {
    const std::size_t count = std::max<std::size_t>(1, model_->animations().size());
    switch (pressed) {
        case KeySpace:
            if (playback_.atEnd())
                playClip(clip_, 0.0);
            else
                playback_.paused = !playback_.paused;
            return true;
        case KeyComma:
            playback_.step(-1);
            return true;
        case KeyPeriod:
            playback_.step(+1);
            return true;
        case KeyMinus:
            playback_.speed /= kSpeedStep;
            return true;
        case KeyEqual:
            playback_.speed *= kSpeedStep;
            return true;
        case KeyHome:
            playClip(clip_, 0.0);
            return true;
        case KeyTab:
            playClip((clip_ + ((modifiers & ModShift) ? count - 1 : 1)) % count, 0.0);
            return true;
        default:
            return false;
    }
}

bool Viewer::lookKey(int pressed, int modifiers) {
    RenderOptions& look = settings_.look;
    bool* option = pressed == 'A' && (modifiers & ModShift) ? &look.skeleton
                   : pressed == 'E'                         ? &look.wireframe
                   : pressed == 'G'                         ? &look.grid
                                                            : nullptr;
    if (option) *option = !*option;
    return option != nullptr;
}

void Viewer::draw() {
    const Window::Size size = window_.framebufferSize();
    if (size.width <= 0 || size.height <= 0) return;  // minimised
    if (clip()) model_->sampleAt(clip()->startSeconds + playback_.time());
    renderer_.render(*model_, camera_.camera(aspect()), RenderTarget{0, size.width, size.height},
                     settings_.look);
    window_.swapBuffers();
    changed_ = false;
}

void Viewer::updateTitle() {
    std::string title = baseName(settings_.file);
    if (clip())
        title += " - " + clip()->name + " - " + formatFixed(playback_.time(), 2) + " / " +
                 formatFixed(clip()->lengthInSeconds(), 2) + " s";
    if (playback_.paused) title += " - paused";
    if (std::abs(playback_.speed - 1.0) > 1e-9) title += " - x" + formatFixed(playback_.speed, 2);
    if (title != title_) window_.setTitle(title);
    title_ = std::move(title);
}

void Viewer::run() {
    double last = window_.time();
    while (!window_.shouldClose()) {
        const double now = window_.time();
        const bool moving = clip() && !playback_.paused && !playback_.atEnd();
        playback_.advance(std::min(now - last, kLongestFrame));
        last = now;
        if (settings_.watch && watch_.changed(now)) reload();
        if (moving || changed_) draw();
        updateTitle();
        // Where the driver does not wait for the screen, this does: no faster than 60 pictures a second, and
        // nothing at all while nothing moves.
        const double left = kSecondsPerFrame - (window_.time() - now);
        if (!moving)
            window_.waitEvents(settings_.watch ? 0.2 : 1.0);
        else if (left > 0.001)
            window_.waitEvents(left);
        else
            window_.pollEvents();
    }
}

}  // namespace walkcycle
