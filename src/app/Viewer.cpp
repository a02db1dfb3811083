#include "app/Viewer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <utility>

#include "app/Clips.h"
#include "app/FormatNumber.h"
#include "app/LoadArguments.h"
#include "app/Messages.h"
#include "loaders/document/Diagnostics.h"

namespace walkcycle {
namespace {

constexpr int kWidth = 1280, kHeight = 720;
constexpr double kSpeedStep = 1.2599210498948732;  // the cube root of 2: three steps double the speed
constexpr double kStepSeconds = 1.0 / 30.0;        // of the keys , and .
constexpr double kSecondsPerFrame = 1.0 / 60.0;    // at least, if the driver does not wait
constexpr double kLongestUpdate = 0.25;  // seconds: after a pause of the system, the clip does not jump

std::string baseName(const std::string& file) {
    return std::filesystem::path(file).filename().string();
}

}  // namespace

const char* viewerHelp() {
    return "left drag: orbit    right drag or shift + left drag: pan    wheel: zoom    Enter: show all "
           "again\n"
           "Space: pause    , and .: a step back or forward    Home: the clip's start    Tab: next clip\n"
           "- and =: slower or faster    Backspace: the clip's own speed\n"
           "Shift+A: skeleton    E: wireframe    G: ground    H: this help    Q or Escape: quit\n";
}

Viewer::Viewer(ViewerSettings settings, Model first)
    : settings_(std::move(settings)),
      window_("Walkcycle", kWidth, kHeight),
      model_(std::make_unique<AnimatedModel>(std::move(first))),
      watch_(settings_.file) {
    model_->setSpeed(settings_.speed);
    model_->setLoopMode(settings_.loopMode);
    if (const Animation* named = findClip(model_->model(), settings_.clip)) {
        playClip(static_cast<std::size_t>(named - model_->animations().data()));
        if (const auto& seconds = settings_.startTime)
            model_->setTime(documentTime(*seconds, named, settings_.clip) - named->startSeconds);
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

bool Viewer::isMoving() const {
    const Animator& animator = model_->animator();
    return clip() && !paused_ && animator.speed() != 0.0 && !animator.atEnd();
}

void Viewer::playClip(std::size_t number) {
    clip_ = number;
    if (clip()) model_->doAnimation(*clip());
    camera_.keep(model_->bounds());
    changed_ = true;
}

// The camera, the speed and the loop mode stay. The clip of the same name begins; if there is none, the first clip.
bool Viewer::load(const std::string& file) {
    const std::string clipName = clip() ? clip()->name : "";
    const double speed = model_->animator().speed();
    const LoopMode loopMode = model_->animator().loopMode();
    try {
        model_ = std::make_unique<AnimatedModel>(settings_.load(file));
    } catch (const LoadError&) {  // printed already
        printNote("kept the model as it was");
        return false;
    } catch (const StrictFailure&) {
        printNote("kept the model as it was");
        return false;
    } catch (const std::exception& error) {
        printError("kept the model as it was: " + std::string(error.what()));
        return false;
    }
    model_->setSpeed(speed);
    model_->setLoopMode(loopMode);
    std::size_t number = 0;
    for (std::size_t i = 0; i < model_->animations().size(); ++i)
        if (model_->animations()[i].name == clipName) number = i;
    playClip(number);
    return true;
}

void Viewer::reload() {
    const double seconds = model_->animator().time();
    if (!load(settings_.file)) return;
    model_->setTime(seconds);
    printNote("loaded " + settings_.file + " again");
}

void Viewer::open(const std::string& file) {
    if (!load(file)) return;
    settings_.file = file;
    watch_ = FileWatch(file);
    camera_.frame(model_->bounds(), aspect());
    printNote("loaded " + file);
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
    window_.onDrop = [this](const std::vector<std::string>& paths) { open(paths.front()); };
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
            if (model_->animator().atEnd()) {
                playClip(clip_);
                paused_ = false;
            } else {
                paused_ = !paused_;
            }
            return true;
        case KeyComma:
        case KeyPeriod:
            paused_ = true;
            model_->step(pressed == KeyComma ? -kStepSeconds : kStepSeconds);
            return true;
        case KeyMinus:
            model_->setSpeed(model_->animator().speed() / kSpeedStep);
            return true;
        case KeyEqual:
            model_->setSpeed(model_->animator().speed() * kSpeedStep);
            return true;
        case KeyBackspace:
            model_->setSpeed(1.0);
            return true;
        case KeyHome:
            model_->setTime(0.0);
            return true;
        case KeyTab:
            playClip((clip_ + ((modifiers & ModShift) ? count - 1 : 1)) % count);
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
    renderer_.render(*model_, camera_.camera(aspect()), RenderTarget{0, size.width, size.height},
                     settings_.look);
    window_.swapBuffers();
    changed_ = false;
}

void Viewer::updateTitle() {
    std::string title = baseName(settings_.file);
    const Animator& animator = model_->animator();
    if (clip())
        title += " - " + clip()->name + " - " + formatFixed(animator.time(), 2) + " / " +
                 formatFixed(clip()->lengthInSeconds(), 2) + " s";
    if (paused_) title += " - paused";
    if (std::abs(animator.speed() - 1.0) > 1e-9) title += " - x" + formatFixed(animator.speed(), 2);
    if (title != title_) window_.setTitle(title);
    title_ = std::move(title);
}

void Viewer::run() {
    double last = window_.time();
    while (!window_.shouldClose()) {
        const double now = window_.time();
        const bool moving = isMoving();
        if (moving) model_->update(std::min(now - last, kLongestUpdate));
        last = now;
        if (settings_.watch && watch_.changed(now)) reload();
        if (moving || changed_) draw();
        updateTitle();
        // Some drivers do not wait for the screen, so this loop waits: it draws at most 60 pictures a second, and none
        // while nothing moves.
        const double left = kSecondsPerFrame - (window_.time() - now);
        if (!moving) {
            window_.waitEvents(settings_.watch ? 0.2 : 1.0);
            last = window_.time();  // the wait does not count as time of the clip
        } else if (left > 0.001) {
            window_.waitEvents(left);
        } else {
            window_.pollEvents();
        }
    }
}

}  // namespace walkcycle
