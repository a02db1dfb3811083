#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/TestFiles.h"
#include "walkcycle/loaders/ColladaLoader.h"

namespace walkcycle {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::IsEmpty;
using ::testing::Le;

const std::string kDrawn = triangle() + scene("<node><instance_geometry url='#mesh'/></node>");

// The document with another root tag, version or asset.
std::string with(std::string text, const std::string& old, const std::string& replacement) {
    return text.replace(text.find(old), old.size(), replacement);
}

std::string fixture(const std::string& name) {
    return WALKCYCLE_FIXTURES "/" + name;
}

TEST(ColladaLoaderTest, aCharacterWithEverythingUnusualPlays) {
    const Model model = loadCollada(fixture("two-bone-arm.dae"));
    EXPECT_THAT(model.diagnostics, IsEmpty());
    ASSERT_EQ(model.animations.size(), 1u);
    // At rest the arm lies along x; at two seconds its elbow (at x = 2) is bent by 90 degrees about z.
    EXPECT_THAT(posed(model, 0.0), ElementsAre(isAt(0, 0, 0), isAt(2, 1, 0), isAt(4, 0, 0)));
    EXPECT_THAT(posed(model, 2.0), ElementsAre(isAt(0, 0, 0), isAt(1.75f, 0.75f, 0), isAt(2, 2, 0)));
    EXPECT_THAT(posed(model, 9.0)[2], isAt(2, 2, 0)) << "the last key holds";
}

TEST(ColladaLoaderTest, theFirstTwoVersionsOf1And4AndTheOneOf5AreRead) {
    for (const char* version : {"1.4.0", "1.4.1", "1.5.0"}) {
        const Model model = loadText(with(collada(kDrawn), "1.4.1", version));
        EXPECT_EQ(model.asset.version, version);
        EXPECT_THAT(model.diagnostics, IsEmpty()) << version;
    }
    EXPECT_THAT(whyNot(with(collada(kDrawn), "1.4.1", "1.3.1")), says("WC0111", 2, "COLLADA"));
    for (const char* odd : {"version=\"2.0\"", "version=\"\"", ""})
        EXPECT_THAT(loadText(with(collada(kDrawn), "version=\"1.4.1\"", odd)).diagnostics,
                    ElementsAre(says("WC0106", 2, "COLLADA")))
            << odd;
}

TEST(ColladaLoaderTest, anyNamespaceWillDoAndAWrongOneIsNoted) {
    const std::string ours = "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\"";
    EXPECT_THAT(
        loadText(with(collada(kDrawn), ours, "xmlns=\"http://www.collada.org/2008/03/COLLADASchema\""))
            .diagnostics,
        IsEmpty());
    EXPECT_THAT(loadText(with(collada(kDrawn), ours, "")).diagnostics, IsEmpty());
    const Model wrong = loadText(with(collada(kDrawn), ours, "xmlns=\"http://example.com/\""));
    EXPECT_THAT(wrong.diagnostics, ElementsAre(says("WC0107", 2, "COLLADA")));
    EXPECT_EQ(wrong.diagnostics[0].severity, Severity::Info);
    EXPECT_EQ(wrong.instances.size(), 1u);
}

TEST(ColladaLoaderTest, prefixedElementsAreTheSameElements) {
    const std::string text = collada(kDrawn);
    std::string prefixed;
    for (std::size_t i = 0; i < text.size(); ++i) {
        prefixed += text[i];
        if (text[i] != '<' || text[i + 1] == '?') continue;
        if (text[i + 1] == '/') prefixed += text[++i];
        prefixed += "dae:";
    }
    const Model model = loadText(with(prefixed, "xmlns=", "xmlns:dae="));
    EXPECT_THAT(posed(model), ElementsAre(isAt(0, 0, 0), isAt(1, 0, 0), isAt(0, 1, 0)));
    EXPECT_THAT(model.diagnostics, IsEmpty());
}

TEST(ColladaLoaderTest, axesAndUnitAreConvertedOnceAtTheRoot) {
    const std::string text = with(with(collada(kDrawn), "Y_UP", "Z_UP"), "meter=\"1\"", "meter=\"0.5\"");
    EXPECT_THAT(posed(loadText(text)), ElementsAre(isAt(0, 0, 0), isAt(0.5f, 0, 0), isAt(0, 0, -0.5f)));
    LoadOptions options;
    options.convert = false;
    EXPECT_THAT(posed(loadText(text, options))[2], isAt(0, 1, 0));
    EXPECT_EQ(loadText(text, options).asset.upAxis, UpAxis::Z);
    options.convert = true;
    options.upAxis = UpAxis::X;
    options.metersPerUnit = 2.0;
    EXPECT_THAT(posed(loadText(text, options))[2], isAt(-2, 0, 0));
}

TEST(ColladaLoaderTest, commentsTabsAndLineBreaksInListsChangeNothing) {
    const std::string spaced =
        with(with(collada(kDrawn), "0 0 0 1 0 0 0 1 0", "\n0\t0 0\r\n1 <!-- x --> 0 0\n\n0 1 0 "),
             "<p>0 1 2</p>", "<p>\n 0\t1<!-- , -->\n2 </p>");
    const Model model = loadText(spaced);
    EXPECT_THAT(posed(model), ElementsAre(isAt(0, 0, 0), isAt(1, 0, 0), isAt(0, 1, 0)));
    EXPECT_THAT(model.diagnostics, IsEmpty());
}

TEST(ColladaLoaderTest, librariesStandInAnyOrder) {
    const std::string geometry = triangle();
    const std::string text = collada(scene("<node><instance_geometry url='#mesh'/></node>") + geometry);
    EXPECT_EQ(loadText(text).instances.size(), 1u);
    EXPECT_THAT(loadText(text).diagnostics, IsEmpty());
}

TEST(ColladaLoaderTest, anInstanceThatLeadsNowhereIsLeftOutWithAnError) {
    const std::string text = collada(
        triangle() +
        scene("<node id='n'>\n<instance_geometry url='#gone'/><instance_geometry url='#mesh'/></node>"));
    const Model model = loadText(text);
    EXPECT_EQ(model.instances.size(), 1u);
    EXPECT_THAT(model.diagnostics,
                ElementsAre(says(
                    "WC0201", lineOf(text, "<instance_geometry"),
                    "COLLADA/library_visual_scenes/visual_scene[id=scene]/node[id=n]/instance_geometry")));
}

TEST(ColladaLoaderTest, twoHundredLevelsOfNodesAreAClearError) {
    std::string deep;
    for (int i = 0; i < 200; ++i) deep += "<node>";
    for (int i = 0; i < 200; ++i) deep += "</node>";
    EXPECT_EQ(whyNot(collada(scene(deep))).code, "WC0104");
}

TEST(ColladaLoaderTest, sixtyLevelsOfJointsLoad) {
    std::string deep;
    for (int i = 0; i < 60; ++i) deep += "<node><translate>1 0 0</translate>";
    deep += "<instance_geometry url='#mesh'/>";
    for (int i = 0; i < 60; ++i) deep += "</node>";
    EXPECT_THAT(posed(loadText(collada(triangle() + scene(deep))))[0], isAt(60, 0, 0));
}

TEST(ColladaLoaderTest, progressGoesFromLittleToAll) {
    std::vector<double> steps;
    LoadOptions options;
    options.progress = [&](double done) { steps.push_back(done); };
    loadText(collada(kDrawn), options);
    ASSERT_FALSE(steps.empty());
    EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
    EXPECT_THAT(steps, Each(AllOf(Ge(0.0), Le(1.0))));
    EXPECT_EQ(steps.back(), 1.0);
}

TEST(ColladaLoaderTest, aLoadCanBeCancelledAtAnyMoment) {
    LoadOptions options;
    int asked = 0;
    options.cancelled = [&] { return ++asked, false; };
    loadText(collada(kDrawn), options);
    ASSERT_GT(asked, 1);
    for (int at = 1; at <= asked; ++at) {
        int count = 0;
        options.cancelled = [&, at] { return ++count == at; };
        EXPECT_EQ(whyNot(collada(kDrawn), options).code, "WC0802") << at;
    }
}

TEST(ColladaLoaderTest, twoLoadsAtOnceDoNotDisturbEachOther) {
    const std::string text = collada(kDrawn);
    std::vector<std::thread> threads;
    std::vector<int> good(4, 0);
    for (int& count : good)
        threads.emplace_back([&text, &count] {
            for (int i = 0; i < 20; ++i)
                count += loadText(text).diagnostics.empty() && loadText(text).instances.size() == 1;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_THAT(good, Each(20));
}

TEST(ColladaLoaderTest, aFileNameMayBeInAnyLanguage) {
    const TestFolder folder;
    for (const char* name :
         {"l\xC3\xA4ufer.dae", "\xE6\xAD\xA9\xE8\xA1\x8C.dae", "with space%20.dae", "a#b.dae"}) {
        const Model model = loadCollada(folder.write(name, collada(kDrawn)));
        EXPECT_EQ(model.instances.size(), 1u) << name;
        EXPECT_THAT(model.file, testing::EndsWith(name));
    }
}

TEST(ColladaLoaderTest, aDocumentMayBePackedWithWhatItRefersTo) {
    const std::string root =
        collada(scene("<node><instance_geometry url='meshes/triangle.dae#mesh'/></node>"));
    const Bytes archive = zipOf({{"walker.dae", root},
                                 {"meshes/triangle.dae", collada(triangle())},
                                 {"manifest.xml", "<dae_root>walker.dae</dae_root>"}});
    EXPECT_EQ(loadCollada(archive, "walker.zae").instances.size(), 1u);
    EXPECT_THAT(loadCollada(archive, "walker.zae").diagnostics, IsEmpty());
    EXPECT_EQ(loadCollada(gzipOf(collada(kDrawn)), "walker.dae.gz").instances.size(), 1u);
}

TEST(ColladaLoaderTest, otherDocumentsLieInTheFolderOrWhereAllowed) {
    const TestFolder folder;
    folder.write("doc/parts/b.dae", collada(triangle()));
    folder.write("elsewhere/b.dae", collada(triangle()));
    const auto root = [&](const std::string& url) {
        return folder.write("doc/a.dae",
                            collada(scene("<node>\n<instance_geometry url='" + url + "'/></node>")));
    };
    EXPECT_EQ(loadCollada(root("parts/b.dae#mesh")).instances.size(), 1u);
    const std::string outside = root("../elsewhere/b.dae#mesh");
    const Model refused = loadCollada(outside);
    EXPECT_THAT(refused.instances, IsEmpty());
    EXPECT_THAT(codes(refused.diagnostics), Contains("WC0208"));
    LoadOptions options;
    options.allowedPaths = {folder.path("elsewhere")};
    EXPECT_EQ(loadCollada(outside, options).instances.size(), 1u);
}

TEST(ColladaLoaderTest, theLimitOfDrawnMeshesHoldsAtItsMesh) {
    const std::string text = collada(
        triangle() + scene("<node><instance_geometry url='#mesh'/><instance_geometry url='#mesh'/></node>"));
    LoadOptions options;
    for (const std::uint64_t limit : {3u, 2u}) {
        options.limits.maxInstances = limit;
        EXPECT_EQ(loadText(text, options).instances.size(), 2u);
    }
    options.limits.maxInstances = 1;
    EXPECT_EQ(whyNot(text, options).code, "WC0801");
}

TEST(ColladaLoaderTest, theLimitOfVerticesCountsEveryInstance) {
    const std::string text = collada(
        triangle() + scene("<node><instance_geometry url='#mesh'/><instance_geometry url='#mesh'/></node>"));
    LoadOptions options;
    options.limits.maxVertices = 6;
    EXPECT_EQ(loadText(text, options).instances.size(), 2u);
    options.limits.maxVertices = 5;
    EXPECT_EQ(whyNot(text, options).code, "WC0801");
}

TEST(ColladaLoaderTest, everythingGivenOnIsFinite) {
    const std::string text = with(collada(kDrawn), "0 0 0 1 0 0", "NaN INF -INF 1e400 1e38 1e-60");
    const Model model = loadText(text);
    for (const glm::vec3& position : posed(model))
        EXPECT_TRUE(std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z));
    EXPECT_THAT(codes(model.diagnostics), Contains("WC0204"));
}

TEST(ColladaLoaderTest, theLocaleChangesNothing) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    const bool hasComma = std::setlocale(LC_ALL, "de_DE.UTF-8") || std::setlocale(LC_ALL, "de_DE");
    const std::string text = with(collada(kDrawn), "meter=\"1\"", "meter=\"0.5\"");
    EXPECT_THAT(posed(loadText(text))[1], isAt(0.5f, 0, 0));
    std::setlocale(LC_ALL, before.c_str());
    if (!hasComma) GTEST_SKIP() << "no German locale is installed; loaded under the default one";
}

}  // namespace
}  // namespace walkcycle
