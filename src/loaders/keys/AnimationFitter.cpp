#include "loaders/keys/AnimationFitter.h"

#include <cstddef>
#include <string>

#include "loaders/document/LoadProgress.h"
#include "loaders/keys/ClipFitter.h"

namespace walkcycle {
namespace {

// The name of the whole timeline: "walk" for "characters/walk.dae".
std::string baseName(const std::string& file) {
    const std::size_t slash = file.find_last_of("/\\");
    const std::string name = slash == file.npos ? file : file.substr(slash + 1);
    const std::size_t dot = name.rfind('.');
    return dot == name.npos || dot == 0 ? name : name.substr(0, dot);
}

}  // namespace

void fitAnimations(const LoadedMotion& loaded, XmlNode collada, const LoadContext& context, Model& model) {
    if (!loaded.motion) return;
    model.exactMotion = loaded.motion;
    if (context.progress) context.progress->begin(LoadProgress::Stage::Keys, workOf(*loaded.motion));
    model.animations =
        ClipFitter(model, *loaded.motion, context, collada).fit(baseName(model.file), loaded.clips);
}

}  // namespace walkcycle
