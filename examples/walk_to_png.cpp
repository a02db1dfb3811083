// A moment of the walk as a picture, without a window.
#include <cstdio>
#include <exception>

#include <walkcycle/walkcycle.h>

using namespace walkcycle;

int main(int argc, char** argv) try {
    HeadlessContext context;
    AnimatedModel model(loadCollada(argc > 1 ? argv[1] : "res/walker.dae"));
    AnimatedModelRenderer renderer;
    Framebuffer picture(1280, 720);

    if (!model.animations().empty()) model.doAnimation(model.animations().front());
    model.setTime(0.4);  // seconds into the walk; a file without clips stays in its rest pose
    renderer.render(model, Camera::framing(model.bounds(), picture.aspect()), picture);
    savePng(picture.read(), argc > 2 ? argv[2] : "walk.png");
} catch (const std::exception& error) {  // no such file, nothing in it that can be shown, no graphics device
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
