#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/scene/SkeletonLoader.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// The nodes of a scene as the loader lists them.
struct LoadedScene {
    explicit LoadedScene(const std::string& nodes, const std::string& more = {}, LoadOptions options = {})
        : text("<COLLADA>" + more + "\n<visual_scene id='scene'>\n" + nodes + "</visual_scene></COLLADA>"),
          load(text, std::move(options)),
          skeletons(load.context, asset, load.collada) {
        skeletons.addScene(load.byId("scene"));
    }
    const std::vector<Joint>& joints() { return skeletons.scene().skeleton.joints; }
    std::vector<std::string> names() {
        std::vector<std::string> all;
        for (const Joint& joint : joints()) all.push_back(joint.name);
        return all;
    }
    std::vector<int> parents() {
        std::vector<int> all;
        for (const Joint& joint : joints()) all.push_back(joint.parent);
        return all;
    }

    std::string text;
    TestLoad load;
    Asset asset;
    SkeletonLoader skeletons;
};

std::string chainOf(int length, const std::string& attributes) {
    std::string text;
    for (int i = 0; i < length; ++i) text += "<node " + attributes + ">";
    for (int i = 0; i < length; ++i) text += "</node>";
    return text;
}

TEST(SkeletonLoaderTest, parentsComeBeforeChildrenInDocumentOrder) {
    LoadedScene scene(
        "<node name='a'><node name='b'><node name='c'/></node><node name='d'/></node><node name='e'/>");
    EXPECT_THAT(scene.names(), ElementsAre("a", "b", "c", "d", "e"));
    EXPECT_THAT(scene.parents(), ElementsAre(kNoParent, 0, 1, 0, kNoParent));
}

TEST(SkeletonLoaderTest, aJointKeepsItsNamesAndItsTransform) {
    LoadedScene scene(
        "<node id='i' name='n' sid='s' type='JOINT'><translate>1 2 3</translate><scale>2 2 2</scale></node>"
        "<node/>");
    const Joint& joint = scene.joints()[0];
    EXPECT_EQ(joint.id + joint.name + joint.sid, "ins");
    EXPECT_TRUE(joint.isJoint);
    EXPECT_FALSE(scene.joints()[1].isJoint);
    EXPECT_EQ(joint.localBindTransform * glm::vec4(1, 1, 1, 1), glm::vec4(3, 4, 5, 1));
}

TEST(SkeletonLoaderTest, anInstancedNodeOccursEachTime) {
    LoadedScene scene(
        "<node name='left'><instance_node url='#leg'/></node>"
        "<node name='right'><node name='own'/><instance_node url='#leg'/></node>",
        "<library_nodes><node id='leg' name='leg'><node name='foot'/></node></library_nodes>");
    EXPECT_THAT(scene.names(), ElementsAre("left", "leg", "foot", "right", "own", "leg", "foot"));
    EXPECT_THAT(scene.parents(), ElementsAre(kNoParent, 0, 1, kNoParent, 3, 3, 5));
    EXPECT_EQ(scene.skeletons.scene().occurrences.count(scene.load.byId("leg")), 2u);
}

TEST(SkeletonLoaderTest, instancesNestAndComeFromOtherDocuments) {
    LoadOptions options;
    options.resolver = [](const std::string&) {
        return std::optional(
            bytesOf("<COLLADA><asset><unit meter='0.01'/></asset>"
                    "<library_nodes><node id='foot' name='foot'><translate>100 0 0</translate></node>"
                    "</library_nodes></COLLADA>"));
    };
    LoadedScene scene("<node name='hip'><instance_node url='#leg'/></node>",
                      "<node id='leg' name='leg'><instance_node url='other.dae#foot'/></node>", options);
    EXPECT_THAT(scene.names(), ElementsAre("hip", "leg", "foot"));
    EXPECT_NEAR(scene.joints()[2].localBindTransform[3].x, 1.0f, 1e-6f)
        << "centimetres become the document's metres";
    EXPECT_THAT(scene.load.diagnostics.all(), IsEmpty());
}

TEST(SkeletonLoaderTest, aLoopOfInstancesIsCutAndReported) {
    LoadedScene scene("<node name='top'>\n<instance_node url='#a'/></node>",
                      "<node id='a' name='a'><instance_node url='#b'/></node>"
                      "<node id='b' name='b'><instance_node url='#a'/></node>");
    EXPECT_THAT(scene.names(), ElementsAre("top", "a", "b"));
    EXPECT_THAT(scene.load.diagnostics.all(),
                ElementsAre(says("WC0206", 1, "COLLADA/node[id=b]/instance_node")));
}

TEST(SkeletonLoaderTest, aNodeThatInstancesItselfIsALoopOfOne) {
    LoadedScene scene("<node id='a' name='a'>\n<instance_node url='#a'/></node>");
    EXPECT_THAT(scene.names(), ElementsAre("a"));
    EXPECT_THAT(scene.load.diagnostics.all(),
                ElementsAre(says("WC0206", 4, "COLLADA/visual_scene[id=scene]/node[id=a]/instance_node")));
}

TEST(SkeletonLoaderTest, anInstanceThatLeadsNowhereOrElsewhereIsReported) {
    LoadedScene scene("<node>\n<instance_node url='#gone'/>\n<instance_node url='#camera'/></node>",
                      "<camera id='camera'/>");
    EXPECT_EQ(scene.joints().size(), 1u);
    const std::string path = "COLLADA/visual_scene[id=scene]/node/instance_node";
    EXPECT_THAT(scene.load.diagnostics.all(), ElementsAre(says("WC0201", 4, path), says("WC0207", 5, path)));
}

TEST(SkeletonLoaderTest, theLimitOfNodesHoldsAtItsNode) {
    for (const std::uint64_t limit : {4u, 3u}) {
        LoadOptions options;
        options.limits.maxNodes = limit;
        EXPECT_EQ(LoadedScene(chainOf(3, ""), "", options).joints().size(), 3u);
    }
    LoadOptions options;
    options.limits.maxNodes = 2;
    EXPECT_THROW(LoadedScene(chainOf(3, ""), "", options), LoadError);
}

TEST(SkeletonLoaderTest, instancesThatMultiplyStopAtTheLimit) {
    std::string levels;
    for (int i = 0; i < 40; ++i) {
        const std::string next = "<instance_node url='#n" + std::to_string(i + 1) + "'/>";
        levels += "<node id='n" + std::to_string(i) + "'>" + next + next + "</node>";
    }
    levels += "<node id='n40'/>";
    LoadOptions options;
    options.limits.maxNodes = 5000;
    EXPECT_THROW(LoadedScene("<node><instance_node url='#n0'/></node>", levels, options), LoadError);
}

TEST(SkeletonLoaderTest, aNodesOwnAssetConvertsWhatItHolds) {
    LoadedScene scene(
        "<node><asset><unit meter='0.01'/></asset><translate>100 0 0</translate>"
        "<node><translate>100 0 0</translate></node></node>");
    EXPECT_NEAR(scene.joints()[0].localBindTransform[3].x, 1.0f, 1e-6f);
    EXPECT_NEAR(scene.joints()[0].localBindTransform[0].x, 0.01f, 1e-6f);
    EXPECT_EQ(scene.joints()[1].localBindTransform[3].x, 100.0f) << "converted with its parent already";
}

TEST(SkeletonLoaderTest, transformsBeyondAllMeasureAreReportedAndLeftOut) {
    LoadedScene scene(
        "<node id='a'><scale>1e15 1e15 1e15</scale>\n<node id='b'><scale>1e15 1e15 1e15</scale></node>"
        "<node id='c'><translate>1 0 0</translate></node></node>");
    EXPECT_EQ(scene.joints()[1].localBindTransform, glm::mat4(1.0f));
    EXPECT_EQ(scene.joints()[2].localBindTransform[3].x, 1.0f);
    EXPECT_THAT(scene.load.diagnostics.all(),
                ElementsAre(says("WC0712", 4, "COLLADA/visual_scene[id=scene]/node[id=a]/node[id=b]")));
}

TEST(SkeletonLoaderTest, whatIsInstancedIsListedWithItsNode) {
    LoadedScene scene(
        "<node><instance_camera url='#c'/><node><instance_geometry url='#g'/><instance_light url='#l'/>"
        "<instance_controller url='#s'/></node></node>");
    const SceneGraph& graph = scene.skeletons.scene();
    EXPECT_EQ(graph.cameras.at(0).node, 0);
    EXPECT_EQ(graph.geometries.at(0).node, 1);
    EXPECT_EQ(graph.controllers.at(0).node, 1);
    EXPECT_EQ(graph.lights.at(0).element.attribute("url"), "#l");
}

TEST(SkeletonLoaderTest, whatOnlyASkinUsesIsAddedUndrawn) {
    LoadedScene scene(
        "<node name='a'/>",
        "<node id='rig' name='rig'><node name='hip'><instance_geometry url='#g'/></node></node>");
    EXPECT_EQ(scene.skeletons.addUndrawn(scene.load.byId("rig")), 1);
    EXPECT_THAT(scene.names(), ElementsAre("a", "rig", "hip"));
    EXPECT_THAT(scene.skeletons.scene().drawn, ElementsAre(true, false, false));
    EXPECT_THAT(scene.skeletons.scene().geometries, IsEmpty());
}

}  // namespace
}  // namespace walkcycle
