#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>

#include "allocation/FailingAllocation.h"
#include "loaders/AnimationText.h"
#include "loaders/LoadText.h"
#include "loaders/TestFiles.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {

#ifdef WALKCYCLE_ADDRESS_SANITIZER
constexpr std::uint64_t kStep = 5;  // ten times slower: each fifth request
#else
constexpr std::uint64_t kStep = 1;
#endif

// A little of everything: a skin over a morph, a second document, pictures (one guessed, one missing), two clips, a
// camera, a light, a polygon with a hole, and faults to report.
std::string character() {
    SkinText skin;
    skin.source = "#smile";
    AnimationText walk{.target = "hip/t.Y", .times = "0 1 2", .values = "0 1 0", .id = "walk"};
    AnimationText bend{.target = "knee/r.ANGLE",
                       .times = "0 1",
                       .values = "0 170",
                       .interpolations = "BEZIER",
                       .inTangents = "0 0 0.5 90",
                       .outTangents = "0.5 90 1 170",
                       .id = "bend"};
    AnimationText grin{.target = "weights(0)", .times = "0 1", .values = "0 1", .id = "grin"};
    const std::string morph =
        "<controller id='smile'><morph source='#mesh'>" + nameSource("targets", "high", "IDREF_array") +
        floatSource("weights", "0.5", "W") +
        "<targets><input semantic='MORPH_TARGET' source='#targets'/><input semantic='MORPH_WEIGHT' "
        "source='#weights'/></targets></morph></controller>";
    std::string mesh = triangle();
    mesh.insert(mesh.find("<triangles") + 10, " material='paint'");
    const std::string paint =
        "<library_images><image id='coat'><init_from>Skin.PNG</init_from></image><image id='gone'><init_from>"
        "gone.png</init_from></image></library_images><library_effects><effect "
        "id='e'><profile_COMMON><technique "
        "sid='c'><phong><diffuse><texture texture='coat' texcoord='UV'/></diffuse><emission><texture "
        "texture='gone' "
        "texcoord='UV'/></emission></phong></technique></profile_COMMON></effect></library_effects>"
        "<library_materials><material id='m'><instance_effect url='#e'/></material></library_materials>";
    const std::string optics =
        "<library_cameras><camera "
        "id='eye'><optics><technique_common><perspective><yfov>45</yfov></perspective>"
        "</technique_common></optics></camera></library_cameras><library_lights><light "
        "id='sun'><technique_common>"
        "<directional><color>1 1 1</color></directional></technique_common></light></library_lights>";
    const std::string clips =
        "<library_animation_clips><animation_clip id='a' start='0' end='1'><instance_animation url='#walk'/>"
        "</animation_clip><animation_clip id='b' start='0' end='1'><instance_animation url='#bend'/>"
        "</animation_clip></library_animation_clips>";
    const std::string nodes =
        "<node id='hip' sid='hip'><translate sid='t'>0 0 0</translate><node id='knee' sid='knee'><rotate "
        "sid='r'>0 0 1 "
        "0</rotate></node></node><node><instance_controller "
        "url='#skin'><skeleton>#hip</skeleton><bind_material>"
        "<technique_common><instance_material symbol='paint' target='#m'/></technique_common></bind_material>"
        "</instance_controller><instance_geometry url='parts.dae#wheel'/><instance_camera url='#eye'/>"
        "<instance_light url='#sun'/><instance_node url='#nowhere'/></node>";
    return collada(paint + optics + mesh + triangle("high", "0 0 1 1 0 1 0 1 1") +
                   controllers(morph + skin.text()) + animations(walk.text() + bend.text() + grin.text()) +
                   clips + scene(nodes));
}

std::string parts() {
    return collada(
        "<library_geometries><geometry id='wheel'><mesh>" +
        floatSource("at", "0 0 0 9 0 0 9 9 0 0 9 0 5 1 0 4 4 0 3 3 0 4 3 0 3 4 0") +
        "<vertices id='v'><input semantic='POSITION' source='#at'/></vertices><polygons count='1'><input "
        "semantic='VERTEX' source='#v' offset='0'/><ph><p>0 4 1 2 3</p><h>5 6 7</h></ph></polygons></mesh>"
        "</geometry></library_geometries>");
}

std::string picture() {
    const Bytes png = encodePng({.width = 8, .height = 8, .hasAlpha = false, .rgba = Bytes(8 * 8 * 4, 200)});
    return {png.begin(), png.end()};
}

std::size_t messages(const Model& model) {
    return model.diagnostics.size();
}

std::string said(const Model& model) {
    std::string lines;
    for (const Diagnostic& diagnostic : model.diagnostics) lines += toString(diagnostic) + "\n";
    return lines;
}

// Some requests have a substitute: sorting goes without a buffer, for one.
bool showTheSame(const Model& a, const Model& b) {
    const auto pictures = [](const Model& model) {
        return std::count_if(model.textures.begin(), model.textures.end(),
                             [](const Texture& texture) { return texture.image != nullptr; });
    };
    return a.animations.size() == b.animations.size() && a.materials.size() == b.materials.size() &&
           a.cameras.size() == b.cameras.size() && a.lights.size() == b.lights.size() &&
           pictures(a) == pictures(b) && a.instances.size() == b.instances.size() &&
           posed(a, 0.7) == posed(b, 0.7);
}

// Refuses the 1st, the 2nd, the 3rd ... request for memory of a load, until one passes without being refused any.
template <typename Load>
void refuseEach(Load load) {
    const Model whole = load();  // and what libraries keep for ever is there from here on
    const std::size_t usual = messages(whole);
    std::uint64_t n = 1, thrown = 0, reported = 0;
    for (bool passed = false; !passed; n += kStep) {
        bool loaded = false, happened = false;
        Model model;
        try {
            const FailingAllocation failing(n);
            model = load();
            happened = failing.happened();
            loaded = true;
        } catch (const std::bad_alloc&) {
            ++thrown;
        } catch (const LoadError&) {
            ++thrown;
        }
        passed = loaded && !happened;
        if (loaded && happened) {
            EXPECT_TRUE(said(model) != said(whole) || showTheSame(model, whole))
                << "request " << n << " was refused, and nothing is said of it";
            ++reported;
        }
    }
    EXPECT_EQ(messages(load()), usual) << "the next load is as good as the first";
    EXPECT_GT(thrown, 100u);
    testing::Test::RecordProperty("requests", std::to_string(n));
    testing::Test::RecordProperty("reported", std::to_string(reported));
}

TEST(AllocationFailureTest, anArchiveEndsInAnErrorWhereverMemoryRunsOut) {
    const Bytes archive =
        zipOf({{"walker.dae", character()}, {"parts.dae", parts()}, {"textures/skin.png", picture()}});
    const Model model = loadCollada(archive, "walker.zae");
    ASSERT_EQ(model.instances.size(), 2u);
    ASSERT_EQ(model.animations.size(), 3u);
    ASSERT_FALSE(model.textures.empty());
    refuseEach([&] { return loadCollada(archive, "walker.zae"); });
}

TEST(AllocationFailureTest, aFolderEndsInAnErrorWhereverMemoryRunsOut) {
    const TestFolder folder;
    const std::string path = folder.write("walker.dae", character());
    folder.write("parts.dae", parts());
    folder.write("textures/skin.png", picture());
    ASSERT_EQ(loadCollada(path).instances.size(), 2u);
    refuseEach([&] { return loadCollada(path); });
}

}  // namespace
}  // namespace walkcycle
