// Loads a file, plays its first clip for half a second, and prints where its joints are.
#include <cstddef>
#include <cstdio>
#include <vector>

#include <walkcycle/animation/Animator.h>
#include <walkcycle/crowd/CrowdPoser.h>
#include <walkcycle/loaders/ColladaLoader.h>

#include "animation/Animator.h"
#include "io/File.h"
#include "model/Model.h"
#include "render/Framebuffer.h"

using namespace walkcycle;

static_assert(kMyAnimator + kMyFile + kMyModel + kMyFramebuffer == 4);

int main(int argc, char** argv) try {
    if (argc < 2) return 2;
    const Model model = loadCollada(argv[1]);
    Animator animator(model.skeleton, model.restParameters());
    animator.doAnimation(model.animations.at(0));
    animator.update(0.5);
    for (std::size_t i = 0; i < model.skeleton.joints.size(); ++i)
        std::printf("%s %g\n", model.skeleton.joints[i].name.c_str(),
                    static_cast<double>(animator.modelTransforms()[i][3].y));
    return 0;
} catch (const LoadError& error) {  // also across the border of a shared library
    std::fprintf(stderr, "LoadError: %s\n", error.what());
    return 1;
}
