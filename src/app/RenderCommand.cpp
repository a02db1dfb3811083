#include <algorithm>
#include <cstddef>
#include <exception>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/CameraChoice.h"
#include "app/Clips.h"
#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/FramePattern.h"
#include "app/Graphics.h"
#include "app/LoadArguments.h"
#include "app/Numbers.h"
#include "app/PictureFile.h"
#include "app/SharedOptions.h"
#include "app/Sheet.h"
#include "app/Shots.h"
#include "render/SampleAverage.h"
#include "walkcycle/platform/NoGraphicsDevice.h"
#include "walkcycle/render/AnimatedModelRenderer.h"
#include "walkcycle/render/Framebuffer.h"

namespace walkcycle {
namespace {

constexpr int kMostPixelsASide = 32768;

struct RenderArguments {
    LoadArguments load;
    ShotList shots;
    CameraChoice camera;
    RenderOptions look;
    std::string file, output, clip, background, backend = "auto";
    std::pair<int, int> resolution{1280, 720};
    int samples = 4;
    bool noBackground = false, noGrid = false;
};

void declareLookGroup(RenderArguments& options, Arguments& arguments) {
    arguments.group("Look");
    declareLook(arguments, options.look);
    arguments.option("--background", "#rrggbb", "One colour as the background", options.background);
    arguments.flag("--no-background", "No background: transparent, with straight alpha",
                   options.noBackground);
    arguments.flag("--no-grid", "No grid on the ground", options.noGrid);
    arguments.option(
        "--samples", "N",
        "Samples per pixel, 1 to 64 (4); more than the device has are drawn in several passes",
        [&options](const std::string& text) { options.samples = parseInteger(text, "--samples", 1, 64); });
}

void declare(RenderArguments& options, Arguments& arguments) {
    declareDocument(arguments, options.file);
    arguments.option(
        "--output,-o", "FILE",
        "out.png, out.webp, out_{frame:04}.png for several pictures, or - (PNG to standard output)",
        options.output);
    arguments.option("--resolution", "W,H", "Size of the picture in pixels (1280,720)",
                     [&options](const std::string& text) {
                         const char separator = text.find(',') == std::string::npos ? 'x' : ',';
                         options.resolution = parsePair(text, separator, "--resolution", kMostPixelsASide);
                     });
    declareClip(arguments, options.clip);
    arguments.choice("--backend", {"auto", "egl", "glfw"},
                     "Draw without a display (egl), or through a hidden window (glfw)", options.backend);
    options.shots.declare(arguments);
    options.camera.declare(arguments);
    declareLookGroup(options, arguments);
    options.load.declare(arguments);
    arguments.examples(
        "  walkcycle render hero.dae -o hero.png --resolution 640,480\n"
        "  walkcycle render hero.dae -o walk_{frame:04}.png --frames 0..23 --fps 24 --camera side\n"
        "  walkcycle render hero.dae -o sheet.png --sheet 4x2 --skeleton\n"
        "  walkcycle render hero.dae -o - --no-background | convert - hero.jpg\n");
}

RenderOptions lookOf(const RenderArguments& options) {
    RenderOptions look = options.look;
    look.grid = !options.noGrid && look.lights == Lighting::Studio;
    if (!options.background.empty()) {
        look.background = Background::Color;
        look.backgroundColor = parseColor(options.background, "--background");
    }
    if (options.noBackground) look.background = Background::Transparent;
    return look;
}

// The pattern of the output's names. Throws UsageError for a wrong --output before any work begins.
FramePattern checkedOutput(const RenderArguments& options) {
    if (options.output.empty())
        throw UsageError("there is no output: give --output picture.png, or --output - for standard output");
    if (!isPictureName(options.output))
        throw UsageError("--output: '" + options.output +
                         "' is not a .png or .webp, which are the pictures that can be written");
    return FramePattern(options.output);
}

// Draws the shots of one command, all in the same size.
class Photographer {
public:
    Photographer(const RenderArguments& options, AnimatedModel& model, int width, int height)
        : options_(options),
          model_(model),
          look_(lookOf(options)),
          picture_(width, height, options.samples) {}

    Image take(const Shot& shot) {
        model_.sampleAt(shot.documentSeconds);
        const Camera camera = options_.camera.camera(model_, picture_.aspect(), shot.orbitRadians);
        const int passes = (options_.samples + picture_.samples() - 1) / picture_.samples();
        Image image = passes > 1 ? average(camera, passes) : draw(camera);
        if (look_.background != Background::Transparent) image.hasAlpha = false;
        return image;
    }

private:
    Image draw(const Camera& camera) {
        renderer_.render(model_, camera, picture_, look_);
        return picture_.read();
    }

    Image average(const Camera& camera, int passes) {
        SampleAverage average(passes);
        for (int pass = 0; pass < passes; ++pass)
            average.add(draw(camera.shifted(average.offset(pass), picture_.width(), picture_.height())));
        return average.image();
    }

    const RenderArguments& options_;
    AnimatedModel& model_;
    RenderOptions look_;
    AnimatedModelRenderer renderer_;
    Framebuffer picture_;
};

void takeSheet(const RenderArguments& options, AnimatedModel& model, const std::vector<Shot>& shots,
               const FramePattern& output) {
    Sheet sheet(options.resolution, options.shots.sheet());
    Photographer photographer(options, model, sheet.cellWidth(), sheet.cellHeight());
    Progress progress("drawing", !options.load.quiet);
    for (std::size_t i = 0; i < shots.size() && i < sheet.cellCount(); ++i) {
        sheet.place(i, photographer.take(shots[i]));
        progress.update(static_cast<double>(i + 1) / static_cast<double>(shots.size()));
    }
    writePicture(output.name(0), sheet.image());
}

void takeAll(const RenderArguments& options, AnimatedModel& model, const std::vector<Shot>& shots,
             const FramePattern& output) {
    Photographer photographer(options, model, options.resolution.first, options.resolution.second);
    Progress progress("drawing", !options.load.quiet);
    for (std::size_t i = 0; i < shots.size(); ++i) {
        writePicture(output.name(static_cast<int>(i)), photographer.take(shots[i]));
        progress.update(static_cast<double>(i + 1) / static_cast<double>(shots.size()));
    }
}

// The model and the graphics device. The constructor loads the one on a second thread while it opens the other, because
// both take time. If both fail, the error of the file is thrown; an error of the device is thrown by graphics().
class ModelAndGraphics {
public:
    explicit ModelAndGraphics(const RenderArguments& options) {
        auto loading = std::async(std::launch::async, [&options] { return options.load.load(options.file); });
        try {
            graphics_ = std::make_unique<Graphics>(options.backend);
        } catch (const NoGraphicsDevice&) {
            noDevice_ = std::current_exception();
        }
        model = loading.get();
    }

    const Graphics& graphics() const {
        if (noDevice_) std::rethrow_exception(noDevice_);
        return *graphics_;
    }

private:
    std::unique_ptr<Graphics> graphics_;
    std::exception_ptr noDevice_;

public:
    Model model;
};

int run(const RenderArguments& options) {
    const FramePattern output = checkedOutput(options);
    lookOf(options);  // throws if a value is wrong
    ModelAndGraphics opened(options);
    Model& loaded = opened.model;
    options.camera.check(loaded);
    const Animation* clip = findClip(loaded, options.clip);
    const std::vector<Shot> shots = options.shots.shots(clip, options.clip);
    if (shots.size() > 1 && !output.hasFrame() && !options.shots.isSheet())
        throw UsageError("--output: " + std::to_string(shots.size()) +
                         " pictures need a name with {frame}, or --sheet");

    const Graphics& graphics = opened.graphics();
    if (options.load.verbose) printNote(graphics.description());
    const int most = maxFramebufferSize();
    if (std::max(options.resolution.first, options.resolution.second) > most)
        throw UsageError("--resolution: this device draws at most " + std::to_string(most) +
                         " pixels a side");
    const auto number = clip ? clip - loaded.animations.data() : 0;
    AnimatedModel model(std::move(loaded));
    if (clip) model.doAnimation(model.animations()[static_cast<std::size_t>(number)]);
    if (options.shots.isSheet())
        takeSheet(options, model, shots, output);
    else
        takeAll(options, model, shots, output);
    return kFine;
}

}  // namespace

Command renderCommand() {
    const auto options = std::make_shared<RenderArguments>();
    return {"Pictures of a model, even without a display",
            [options](Arguments& arguments) { declare(*options, arguments); },
            [options] { return run(*options); }};
}

}  // namespace walkcycle
