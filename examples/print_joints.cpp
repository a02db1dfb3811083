// Where each joint of a file is half a second into its motion: loading and posing, without OpenGL.
#include <cstddef>
#include <cstdio>

#include <walkcycle/animation/Animator.h>
#include <walkcycle/loaders/ColladaLoader.h>

using namespace walkcycle;

int main(int argc, char** argv) try {
    const Model model = loadCollada(argc > 1 ? argv[1] : "res/walker.dae");
    for (const Diagnostic& diagnostic : model.diagnostics)
        std::fprintf(stderr, "%s\n", toString(diagnostic).c_str());

    Animator animator(model.skeleton, model.restParameters());
    if (!model.animations.empty()) animator.doAnimation(model.animations.front());
    animator.setTime(0.5);
    for (std::size_t i = 0; i < model.skeleton.joints.size(); ++i) {
        const glm::vec4& position = animator.modelTransforms()[i][3];  // in metres, Y up
        std::printf("%-20s %8.3f %8.3f %8.3f\n", model.skeleton.joints[i].name.c_str(),
                    static_cast<double>(position.x), static_cast<double>(position.y),
                    static_cast<double>(position.z));
    }
} catch (const LoadError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
