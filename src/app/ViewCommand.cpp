#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/BuiltInModel.h"
#include "app/Clips.h"
#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/LoadArguments.h"
#include "app/Numbers.h"
#include "app/SharedOptions.h"
#include "app/Viewer.h"
#include "walkcycle/model/Model.h"
#include "walkcycle/platform/NoGraphicsDevice.h"

namespace walkcycle {
namespace {

struct ViewOptions {
    LoadArguments load;
    std::string file, clip;
    std::vector<std::string> animationFiles;
    std::optional<double> time;
    double speed = 1.0;
    LoopMode loop = LoopMode::Loop;
    bool watch = false;
    RenderOptions look;
};

double parseSpeed(const std::string& text) {
    const double speed = parseNumber(text, "--speed");
    const double size = std::abs(speed);
    if (size != 0.0 && (size < Animator::kSlowest || size > Animator::kFastest))
        throw UsageError("--speed: '" + text + "' is not 0, 1/128 to 128, or (backwards) -128 to -1/128");
    return speed;
}

void declare(ViewOptions& options, Arguments& arguments) {
    arguments.positional("FILE", "The document; without one, the built-in character", options.file,
                         Arguments::Need::Optional);
    arguments.options("--anim", "FILE", "Clips from another file with the same joint names; may be repeated",
                      options.animationFiles);
    declareClip(arguments, options.clip);
    arguments.option(
        "--time,-t", "S",
        "The moment to begin at, in seconds on the document's timeline; with --clip, from the clip's start",
        [&options](const std::string& text) { options.time = parseNumber(text, "--time"); });
    arguments.option("--speed", "X",
                     "Speed of playing, 1/128 to 128; negative: backwards; 0: stands still (1)",
                     [&options](const std::string& text) { options.speed = parseSpeed(text); });
    arguments.choiceOf<LoopMode>(
        "--loop", {{"once", LoopMode::Once}, {"loop", LoopMode::Loop}, {"pingpong", LoopMode::PingPong}},
        "At the clip's end: stop, start again, or play backwards (loop)", options.loop);
    arguments.flag("--watch", "Load the file again when it changes", options.watch);
    declareLook(arguments, options.look);
    options.load.declare(arguments);
    arguments.examples(
        std::string(
            "  walkcycle hero.dae --watch\n"
            "  walkcycle view hero.dae --anim run.dae --anim jump.dae --speed 0.5\n\nIn the window:\n") +
        viewerHelp());
}

// Loads the document, and appends the clips of the files of --anim to its own.
Model loadWithClips(const ViewOptions& options, const std::string& file) try {
    Model model = options.load.load(file);
    for (const std::string& name : options.animationFiles) {
        const std::vector<Animation> clips = borrowClips(options.load.load(name), model);
        model.animations.insert(model.animations.end(), clips.begin(), clips.end());
    }
    return model;
} catch (const NothingToBorrow& error) {
    throw UsageError("--anim: " + std::string(error.what()));
}

int run(const ViewOptions& options) {
    ViewerSettings settings;
    settings.file = options.file.empty() ? builtInModel() : options.file;
    settings.clip = options.clip;
    settings.look = options.look;
    settings.watch = options.watch;
    settings.startTime = options.time;
    settings.speed = options.speed;
    settings.loopMode = options.loop;
    settings.load = [&options](const std::string& file) { return loadWithClips(options, file); };
    Model first = loadWithClips(options, settings.file);
    findClip(first, options.clip);  // throws for a wrong --clip, before the window opens
    try {
        Viewer viewer(std::move(settings), std::move(first));
        viewer.run();
    } catch (const NoGraphicsDevice& error) {
        throw NoGraphicsDevice(std::string(error.what()) +
                               "; without a display, draw a picture: walkcycle render " +
                               (options.file.empty() ? builtInModel() : options.file) + " -o picture.png");
    }
    return kFine;
}

}  // namespace

Command viewCommand() {
    const auto options = std::make_shared<ViewOptions>();
    return {"A window that plays the model",
            [options](Arguments& arguments) { declare(*options, arguments); },
            [options] { return run(*options); }};
}

}  // namespace walkcycle
