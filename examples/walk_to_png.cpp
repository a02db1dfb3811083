// A moment of the walk as a picture, without a window.
#include <walkcycle/walkcycle.h>

using namespace walkcycle;

int main(int argc, char** argv) {
    HeadlessContext context;
    AnimatedModel model(loadCollada(argc > 1 ? argv[1] : "res/walker.dae"));
    AnimatedModelRenderer renderer;
    Framebuffer picture(1280, 720);

    model.doAnimation(model.animations().front());
    model.setTime(0.4);  // seconds into the walk
    renderer.render(model, Camera::framing(model.bounds(), picture.aspect()), picture);
    savePng(picture.read(), argc > 2 ? argv[2] : "walk.png");
}
