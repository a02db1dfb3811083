#include "loaders/curves/AnimationLoader.h"

#include <utility>

#include "loaders/curves/MotionBuilder.h"
#include "loaders/document/LoadProgress.h"

namespace walkcycle {

LoadedMotion loadAnimations(XmlNode collada, const SceneGraph& scene, const AnimationTargets& targets,
                            const LoadContext& context, Model& model) {
    if (context.progress) context.progress->begin(LoadProgress::Stage::Curves);
    const AnimationTree tree = readAnimationTree(collada);
    std::vector<ClipRange> clips = readClips(collada, tree, context);
    MotionBuilder builder(scene, targets, context, model);
    for (XmlNode channel : tree.channels) {
        context.checkCancelled(channel);
        builder.add(channel);
    }
    const auto together = [&](int a, int b) { return playTogether(clips, a, b); };
    std::shared_ptr<const Motion> motion = builder.finish(together);
    return {std::move(motion), std::move(clips)};
}

}  // namespace walkcycle
