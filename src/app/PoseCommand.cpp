#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/Clips.h"
#include "app/Commands.h"
#include "app/ExactPose.h"
#include "app/ExitCode.h"
#include "app/LoadArguments.h"
#include "app/ObjWriter.h"
#include "app/PoseWriter.h"
#include "app/SharedOptions.h"
#include "walkcycle/animation/Animator.h"
#include "walkcycle/io/File.h"
#include "walkcycle/model/CpuSkinning.h"

namespace walkcycle {
namespace {

struct PoseOptions {
    LoadArguments load;
    std::string file, clip, output = "-";
    std::vector<double> times{0.0};
    bool json = false, exact = false;
};

void declare(PoseOptions& options, Arguments& arguments) {
    declareDocument(arguments, options.file);
    declareTimes(arguments, options.times);
    declareClip(arguments, options.clip);
    arguments.flag("--json", "Print JSON (the default)", options.json);
    arguments.option("--output,-o", "FILE",
                     "The file to write: .json, or .obj for a single time; - is standard output",
                     options.output);
    arguments.flag(
        "--exact",
        "Evaluate the file's own curves in double precision, instead of the key frames made from them",
        options.exact);
    options.load.declare(arguments);
    arguments.examples(
        "  walkcycle pose hero.dae --time 0,0.5 --json          joints and vertices, in the document's axes "
        "and units\n"
        "  walkcycle pose hero.dae --time 0.5 -o hero.obj       the mesh as it stands half a second in\n");
}

PosedModel<float> sampledPose(const Model& model, Animator& animator, double documentSeconds) {
    animator.sampleAt(documentSeconds);
    PosedModel<float> posed{animator.modelTransforms(), {}};
    CpuSkinning skinning;
    for (const MeshInstance& instance : model.instances)
        skinning.positions(model, instance, animator.modelTransforms(), animator.parameters(),
                           posed.positions.emplace_back());
    return posed;
}

template <typename Number, typename Pose>
std::string json(const Model& model, std::span<const double> times, Pose pose) {
    std::vector<PosedModel<Number>> poses;
    for (const double time : times) poses.push_back(pose(time));
    return poseJson<Number>(model, times, poses);
}

std::string exactJson(const Model& model, std::span<const double> times, const Animation* clip,
                      const std::string& wanted) {
    return json<double>(model, times, [&](double time) {
        double seconds = documentTime(time, clip, wanted);
        if (clip)
            seconds = std::clamp(seconds, clip->startSeconds, std::max(clip->startSeconds, clip->endSeconds));
        return exactPose(model, seconds);
    });
}

int run(const PoseOptions& options) {
    const bool obj = options.output.ends_with(".obj");
    if (obj && options.exact) throw UsageError("--exact writes JSON, not an .obj");
    if (obj && options.json) throw UsageError("--json and an .obj output exclude each other");
    LoadArguments load = options.load;
    load.options.convert = false;
    load.options.loadImages = false;
    const std::vector<double>& times = options.times;
    if (obj && times.size() > 1) throw UsageError("an .obj holds one pose: give one --time");
    const Model model = load.load(options.file);
    const Animation* clip = findClip(model, options.clip);
    Animator animator(model.skeleton, model.restParameters());
    if (clip) animator.doAnimation(*clip);

    std::string text;
    if (obj) {
        animator.sampleAt(documentTime(times.front(), clip, options.clip));
        text = poseObj(model, animator);
    } else if (options.exact) {
        text = exactJson(model, times, clip, options.clip);
    } else {
        text = json<float>(model, times, [&](double time) {
            return sampledPose(model, animator, documentTime(time, clip, options.clip));
        });
    }
    writeFile(options.output, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return kFine;
}

}  // namespace

Command poseCommand() {
    const auto options = std::make_shared<PoseOptions>();
    return {"The deformed model and its joints at given times, as JSON or OBJ",
            [options](Arguments& arguments) { declare(*options, arguments); },
            [options] { return run(*options); }};
}

}  // namespace walkcycle
