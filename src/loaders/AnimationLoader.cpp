#include "loaders/AnimationLoader.h"

#include "loaders/ClipFitter.h"
#include "loaders/ClipLoader.h"
#include "loaders/LoadProgress.h"
#include "loaders/MotionBuilder.h"

namespace walkcycle {

namespace {

// "walk" for "characters/walk.dae": what a clip without a name of its own is called.
std::string baseName(const std::string& file) {
    const std::size_t slash = file.find_last_of("/\\");
    const std::string name = slash == file.npos ? file : file.substr(slash + 1);
    const std::size_t dot = name.rfind('.');
    return dot == name.npos || dot == 0 ? name : name.substr(0, dot);
}

}  // namespace

// Curves first, exactly as the file has them; then what they move; then keyframes that play the same.
void loadAnimations(XmlNode collada, const SceneGraph& scene, const AnimationTargets& targets,
                    const LoadContext& context, Model& model) {
    if (context.progress) context.progress->begin(LoadProgress::Stage::Curves);
    const AnimationTree tree = readAnimationTree(collada);
    const std::vector<ClipRange> clips = readClips(collada, tree, context);
    MotionBuilder builder(scene, targets, context, model);
    for (XmlNode channel : tree.channels) {
        context.checkCancelled(channel);
        builder.add(channel);
    }
    const auto together = [&](int a, int b) { return playTogether(clips, a, b); };
    const std::shared_ptr<Motion> motion = builder.finish(together);
    if (!motion) return;

    model.exactMotion = motion;
    if (context.progress) context.progress->begin(LoadProgress::Stage::Keys, workOf(*motion));
    model.animations = ClipFitter(model, *motion, context, collada).fit(baseName(model.file), clips);
}

}  // namespace walkcycle
