#include "loaders/AnimationFitter.h"

#include <algorithm>
#include <string>

#include "loaders/ClipFitter.h"

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

void fitAnimations(const LoadedMotion& loaded, XmlNode collada, const LoadContext& context, Model& model) {
    if (!loaded.motion) return;
    const Motion& motion = *loaded.motion;
    model.exactMotion = loaded.motion;
    ClipFitter fitter(model, motion, context, collada);
    model.animations.push_back(fitter.whole(baseName(model.file)));
    for (const ClipRange& range : loaded.clips) {
        const Motion part = motion.restricted([&](int channel) { return range.plays(channel); });
        if (part.joints.empty() && part.parameters.empty()) continue;
        const double end = std::max(range.start, range.end.value_or(part.end()));
        model.animations.push_back(fitter.clip(range.name, range.start, end, part, model.animations.front()));
    }
}

}  // namespace walkcycle
