#include <optional>
#include <string>

#include "loaders/LoadText.h"
#include "loaders/scene/SceneLoader.h"

namespace walkcycle {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string camera(const std::string& optics) {
    return "<library_cameras><camera id='c' name='Cam'><optics><technique_common>" + optics +
           "</technique_common></optics></camera></library_cameras>\n";
}
std::string light(const std::string& kind) {
    return "<library_lights><light id='l' name='Sun'><technique_common>" + kind +
           "</technique_common></light></library_lights>\n";
}
const std::string kLook = scene("<node><instance_camera url='#c'/><instance_light url='#l'/></node>");

Model withCamera(const std::string& optics) {
    return loadText(collada(camera(optics) + light("<ambient/>") + kLook));
}

SceneLight loadedLight(const std::string& kind) {
    return loadText(collada(camera("<perspective><yfov>45</yfov></perspective>") + light(kind) + kLook))
        .lights.at(0);
}

const std::string kTwoScenes =
    "<library_visual_scenes><visual_scene id='first' name='One'><node "
    "id='a'/></visual_scene></library_visual_scenes>\n"
    "<library_visual_scenes><visual_scene id='second'><node "
    "id='b'/></visual_scene></library_visual_scenes>\n";

TEST(SceneLoaderTest, theSceneElementSaysWhichSceneIsShown) {
    const Model model =
        loadText(collada(kTwoScenes + "<scene><instance_visual_scene url='#second'/></scene>"));
    EXPECT_EQ(model.sceneId, "second");
    EXPECT_EQ(model.skeleton.joints.at(0).id, "b");
    EXPECT_THAT(model.diagnostics, IsEmpty());
}

TEST(SceneLoaderTest, theUserMayChooseAnotherByIdOrName) {
    LoadOptions options;
    for (const char* wanted : {"first", "One"}) {
        options.scene = wanted;
        EXPECT_EQ(
            loadText(collada(kTwoScenes + "<scene><instance_visual_scene url='#second'/></scene>"), options)
                .sceneId,
            "first");
    }
    options.scene = "third";
    const Diagnostic reason = whyNot(collada(kTwoScenes), options);
    EXPECT_THAT(reason, says("WC0703", 2, "COLLADA"));
    EXPECT_THAT(reason.message, HasSubstr("first, second"));
}

TEST(SceneLoaderTest, withoutASceneElementTheFirstIsShownWithAWarning) {
    const Model model = loadText(collada(kTwoScenes));
    EXPECT_EQ(model.sceneId, "first");
    EXPECT_THAT(model.diagnostics, ElementsAre(says("WC0702", 2, "COLLADA")));
}

TEST(SceneLoaderTest, aSceneThatLeadsNowhereIsAnErrorAndTheFirstIsShown) {
    const std::string text = collada(kTwoScenes + "<scene>\n<instance_visual_scene url='#gone'/></scene>");
    const Model model = loadText(text);
    EXPECT_EQ(model.sceneId, "first");
    EXPECT_THAT(model.diagnostics, ElementsAre(says("WC0201", lineOf(text, "<instance_visual"),
                                                    "COLLADA/scene/instance_visual_scene")));
}

TEST(SceneLoaderTest, aDocumentWithoutAnySceneCannotBeShown) {
    EXPECT_THAT(whyNot(collada(triangle())), says("WC0701", 2, "COLLADA"));
    EXPECT_EQ(whyNot(collada("<library_visual_scenes/>")).code, "WC0701");
}

TEST(SceneLoaderTest, everyCombinationOfPerspectiveAnglesIsKeptAsItIs) {
    for (int bits = 1; bits < 8; ++bits) {
        std::string optics;
        if (bits & 1) optics += "<xfov>60</xfov>";
        if (bits & 2) optics += "<yfov sid='YFOV'> 40 </yfov>";
        if (bits & 4) optics += "<aspect_ratio>1.5</aspect_ratio>";
        const Model model =
            withCamera("<perspective>" + optics + "<znear>0.5</znear><zfar>50</zfar></perspective>");
        const SceneCamera& result = model.cameras.at(0);
        EXPECT_FALSE(result.orthographic);
        EXPECT_EQ(result.aspect.has_value(), (bits & 4) != 0) << bits;
        EXPECT_EQ(result.znear, 0.5);
        EXPECT_EQ(result.zfar, 50.0);
        if (bits == 4) {  // an aspect alone is no lens
            EXPECT_EQ(result.yfov, 45.0);
            EXPECT_THAT(codes(model.diagnostics), ElementsAre("WC0704"));
            continue;
        }
        EXPECT_EQ(result.xfov, bits & 1 ? std::optional(60.0) : std::nullopt) << bits;
        EXPECT_EQ(result.yfov, bits & 2 ? std::optional(40.0) : std::nullopt) << bits;
        EXPECT_THAT(model.diagnostics, IsEmpty()) << bits;
    }
}

TEST(SceneLoaderTest, everyCombinationOfOrthographicSizesIsKeptAsItIs) {
    for (int bits = 1; bits < 8; ++bits) {
        std::string optics;
        if (bits & 1) optics += "<xmag>6</xmag>";
        if (bits & 2) optics += "<ymag>4</ymag>";
        if (bits & 4) optics += "<aspect_ratio>1.5</aspect_ratio>";
        const SceneCamera result = withCamera("<orthographic>" + optics + "</orthographic>").cameras.at(0);
        EXPECT_EQ(result.orthographic, bits != 4) << bits;
        EXPECT_EQ(result.xmag, bits & 1 ? std::optional(6.0) : std::nullopt) << bits;
        EXPECT_EQ(result.ymag, bits & 2 ? std::optional(4.0) : std::nullopt) << bits;
        EXPECT_EQ(result.aspect.has_value(), (bits & 4) != 0) << bits;
    }
}

TEST(SceneLoaderTest, opticsThatCannotBeUsedAreReportedAndReplaced) {
    const Model none = withCamera("");
    EXPECT_EQ(none.cameras.at(0).yfov, 45.0);
    EXPECT_THAT(
        none.diagnostics,
        ElementsAre(says("WC0704", 4, "COLLADA/library_cameras/camera[id=c]/optics/technique_common")));
    const Model negative = withCamera("<perspective><xfov>-60</xfov><yfov>0</yfov></perspective>");
    EXPECT_FALSE(negative.cameras.at(0).xfov);
    EXPECT_EQ(negative.cameras.at(0).yfov, 45.0);
    const Model halfUsable = withCamera(
        "<perspective><xfov>wide</xfov><yfov>40</yfov><aspect_ratio>0</aspect_ratio></perspective>");
    EXPECT_FALSE(halfUsable.cameras.at(0).xfov);
    EXPECT_FALSE(halfUsable.cameras.at(0).aspect);
    EXPECT_EQ(halfUsable.cameras.at(0).yfov, 40.0);
    EXPECT_THAT(codes(halfUsable.diagnostics), ElementsAre("WC0210", "WC0210"));
}

TEST(SceneLoaderTest, aCameraStandsAtEachNodeThatInstancesIt) {
    const Model model = loadText(collada(
        camera("<perspective><yfov>45</yfov></perspective>") +
        scene("<node/><node><instance_camera url='#c'/></node><node><instance_camera url='#c'/></node>")));
    ASSERT_EQ(model.cameras.size(), 1u);
    EXPECT_EQ(model.cameras[0].name, "Cam");
    ASSERT_EQ(model.cameraInstances.size(), 2u);
    EXPECT_EQ(model.cameraInstances[0].node, 1);
    EXPECT_EQ(model.cameraInstances[1].node, 2);
}

TEST(SceneLoaderTest, theFourKindsOfLightKeepTheirNumbers) {
    EXPECT_EQ(loadedLight("<ambient><color>1 0.5 0.25</color></ambient>").color, glm::vec3(1, 0.5, 0.25));
    EXPECT_EQ(loadedLight("<directional><color>1 1 1</color></directional>").kind, LightKind::Directional);
    const SceneLight point = loadedLight(
        "<point><color>1 1 1</color><constant_attenuation>2</constant_attenuation>"
        "<linear_attenuation>3</linear_attenuation><quadratic_attenuation>4</quadratic_attenuation></point>");
    EXPECT_EQ(point.kind, LightKind::Point);
    EXPECT_EQ(point.constantAttenuation, 2.0f);
    EXPECT_EQ(point.linearAttenuation, 3.0f);
    EXPECT_EQ(point.quadraticAttenuation, 4.0f);
    const SceneLight spot = loadedLight(
        "<spot><color>1 1 "
        "1</color><falloff_angle>30</falloff_angle><falloff_exponent>2</falloff_exponent></spot>");
    EXPECT_EQ(spot.kind, LightKind::Spot);
    EXPECT_EQ(spot.falloffAngle, 30.0f);
    EXPECT_EQ(spot.falloffExponent, 2.0f);
    EXPECT_EQ(loadedLight("<spot/>").falloffAngle, 180.0f);
}

TEST(SceneLoaderTest, aLightOfNoKindIsLeftOutWithAWarning) {
    const std::string text =
        collada(camera("<perspective><yfov>45</yfov></perspective>") + light("<laser/>") + kLook);
    const Model model = loadText(text);
    EXPECT_THAT(model.lights, IsEmpty());
    EXPECT_THAT(model.lightInstances, IsEmpty());
    EXPECT_THAT(model.diagnostics, Contains(says("WC0705", lineOf(text, "<light "),
                                                 "COLLADA/library_lights/light[id=l]/technique_common")));
}

TEST(SceneLoaderTest, aLightsOddNumberIsAWarningAndTheDefaultStays) {
    const std::string text = collada(
        camera("<perspective><yfov>45</yfov></perspective>") +
        light("<point>\n<color>1 1 NaN</color>\n<linear_attenuation>much</linear_attenuation></point>") +
        kLook);
    const Model model = loadText(text);
    EXPECT_EQ(model.lights.at(0).color, glm::vec3(1, 1, 0));
    EXPECT_EQ(model.lights.at(0).linearAttenuation, 0.0f);
    const std::string path = "COLLADA/library_lights/light[id=l]/technique_common/point/";
    EXPECT_THAT(model.diagnostics,
                ElementsAre(says("WC0210", lineOf(text, "<color"), path + "color"),
                            says("WC0210", lineOf(text, "<linear"), path + "linear_attenuation")));
}

TEST(SceneLoaderTest, aLightsColourOfTwoNumbersIsAWarning) {
    const std::string text = collada(camera("<perspective><yfov>45</yfov></perspective>") +
                                     light("<point>\n<color>0.5 0.25</color></point>") + kLook);
    const Model model = loadText(text);
    EXPECT_EQ(model.lights.at(0).color, glm::vec3(0.5f, 0.25f, 1.0f));
    ASSERT_THAT(codes(model.diagnostics), ElementsAre("WC0607"));
    EXPECT_EQ(model.diagnostics[0].line, lineOf(text, "<color"));
}

TEST(SceneLoaderTest, aSceneOfNothingIsAWarning) {
    const std::string text = collada(scene(""));
    const Model model = loadText(text);
    EXPECT_THAT(model.diagnostics, ElementsAre(says("WC0203", lineOf(text, "<visual_scene"),
                                                    "COLLADA/library_visual_scenes/visual_scene[id=scene]")));
    EXPECT_EQ(model.diagnostics.at(0).severity, Severity::Warning);
}

TEST(SceneLoaderTest, camerasAndLightsThatAreNotThereAreErrors) {
    const std::string text =
        collada(scene("<node>\n<instance_camera url='#c'/>\n<instance_light url='#l'/></node>"));
    EXPECT_THAT(codes(loadText(text).diagnostics), ElementsAre("WC0201", "WC0201"));
}

TEST(SceneLoaderTest, aSceneThatIsWantedWhereThereIsNoneIsSaid) {
    LoadOptions options;
    options.scene = "other";
    const Diagnostic why = whyNot(collada(triangle()), options);
    EXPECT_EQ(why.code, "WC0703");
    EXPECT_THAT(why.message, testing::HasSubstr("none"));
}

TEST(SceneLoaderTest, aLightOfNoKindIsSaidOnceHoweverManyNodesShowIt) {
    const Model model = loadText(
        collada("<library_lights><light id='l'><technique_common/></light></library_lights>" + triangle() +
                scene("<node><instance_light url='#l'/><instance_geometry url='#mesh'/></node>"
                      "<node><instance_light url='#l'/></node>")));
    ASSERT_THAT(codes(model.diagnostics), testing::ElementsAre("WC0705"));
    EXPECT_EQ(model.diagnostics[0].repeats, 0);
    EXPECT_TRUE(model.lightInstances.empty());
}

TEST(SceneLoaderTest, aLightsColourMayHaveAnAlpha) {
    const Model model = loadText(collada(
        "<library_lights><light id='l'><technique_common><ambient><color>1 0.5 0 1</color></ambient>"
        "</technique_common></light></library_lights>" +
        triangle() + scene("<node><instance_light url='#l'/><instance_geometry url='#mesh'/></node>")));
    EXPECT_TRUE(model.diagnostics.empty());
    EXPECT_EQ(model.lights.at(0).color, glm::vec3(1.0f, 0.5f, 0.0f));
}

std::string nodeWithVisibility(const std::string& value) {
    return "<node><extra><technique profile='FCOLLADA'><visibility>" + value +
           "</visibility></technique></extra></node>\n";
}

TEST(SceneLoaderTest, aNodeMayBeHidden) {
    const Model model = loadText(collada(scene("<node/>" + nodeWithVisibility("0.000000") +
                                               nodeWithVisibility("1") + nodeWithVisibility("0"))));
    EXPECT_THAT(model.nodeVisible, ElementsAre(true, false, true, false));
}

TEST(SceneLoaderTest, aVisibilityThatIsNoNumberIsToldAndTheNodeShown) {
    const Model model = loadText(collada(scene("<node/>\n" + nodeWithVisibility("hidden"))));
    EXPECT_THAT(model.nodeVisible, ElementsAre(true, true));
    EXPECT_THAT(codes(model.diagnostics), ElementsAre("WC0210"));
}

}  // namespace
}  // namespace walkcycle
