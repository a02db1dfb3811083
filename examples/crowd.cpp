// A thousand walkers, each at its own place and moment of the walk, in one picture.
#include <cstddef>
#include <span>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <walkcycle/walkcycle.h>

using namespace walkcycle;

constexpr int kRows = 25, kColumns = 40;

int main(int argc, char** argv) {
    HeadlessContext context;
    AnimatedModel model(loadCollada(argc > 1 ? argv[1] : "res/walker.dae"));
    const Animation& walk = model.animations().front();
    model.doAnimation(walk);

    // Where each walker stands, and at which time of the walk it is.
    std::vector<glm::mat4> places;
    std::vector<double> seconds;
    for (int i = 0; i < kRows * kColumns; ++i) {
        const float x = 1.2f * static_cast<float>(i % kColumns), z = -1.5f * static_cast<float>(i / kColumns);
        places.push_back(glm::translate(glm::mat4(1.0f), {x - 0.6f * kColumns, 0.0f, z}));
        seconds.push_back(0.618 * i * walk.lengthInSeconds());
    }

    // This model is one skinned mesh, so one palette is all that a walker needs.
    CrowdPoser poser(model.model().skeleton, walk, model.model().skins.front());
    std::vector<JointRows> palettes(seconds.size() * poser.paletteSize());
    poser.pose(seconds, palettes);
    for (std::size_t i = 0; i < places.size(); ++i)
        place(std::span(palettes).subspan(i * poser.paletteSize(), poser.paletteSize()), places[i]);

    Framebuffer picture(960, 540);
    const Camera camera =
        Camera::lookAt({-6.0f, 5.0f, 8.0f}, {0.0f, 0.0f, -8.0f}, {0.0f, 1.0f, 0.0f}, 35.0f, picture.aspect(),
                       {.min = {-30.0f, -1.0f, -40.0f}, .max = {30.0f, 3.0f, 3.0f}});
    AnimatedModelRenderer renderer;
    renderer.clear(picture);
    CrowdRenderer().draw(model, palettes, camera, picture);
    savePng(picture.read(), argc > 2 ? argv[2] : "crowd.png");
}
