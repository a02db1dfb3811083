#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/TestFiles.h"
#include "loaders/document/LoadProgress.h"

namespace walkcycle {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::Ge;
using ::testing::Le;

// A sheet of side x side quads, its corners told one by one.
std::string sheet(const std::string& id, int side) {
    std::ostringstream positions, corners, counts;
    for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x) positions << x << " " << y << " " << (x * y % 7) << " ";
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int corner = y * (side + 1) + x;
            corners << corner << " " << corner + 1 << " " << corner + side + 2 << " " << corner + side + 1
                    << " ";
            counts << "4 ";
        }
    return "<library_geometries><geometry id='" + id + "'><mesh>" +
           floatSource(id + "-positions", positions.str()) + "<vertices id='" + id +
           "-vertices'><input semantic='POSITION' source='#" + id +
           "-positions'/></vertices><polylist count='" + std::to_string(side * side) +
           "'><input semantic='VERTEX' source='#" + id + "-vertices' offset='0'/><vcount>" + counts.str() +
           "</vcount><p>" + corners.str() + "</p></polylist></mesh></geometry></library_geometries>\n";
}

// Joints that turn for `keys` keys each.
std::string animations(int joints, int keys) {
    std::string text = "<library_animations>";
    std::ostringstream times, angles;
    for (int k = 0; k < keys; ++k) {
        times << k << " ";
        angles << (k * 37 % 90) << ".5 ";
    }
    for (int j = 0; j < joints; ++j) {
        const std::string id = "a" + std::to_string(j);
        std::string how;
        for (int k = 0; k < keys; ++k) how += "LINEAR ";
        text += "<animation>" + floatSource(id + "-in", times.str(), "T") +
                floatSource(id + "-out", angles.str(), "A") + nameSource(id + "-how", how) + "<sampler id='" +
                id + "'><input semantic='INPUT' source='#" + id + "-in'/><input semantic='OUTPUT' source='#" +
                id + "-out'/><input semantic='INTERPOLATION' source='#" + id +
                "-how'/></sampler><channel source='#" + id + "' target='j" + std::to_string(j) +
                "/turn.ANGLE'/></animation>\n";
    }
    return text + "</library_animations>\n";
}

std::string nodes(int joints) {
    std::string text = "<node><instance_geometry url='#mesh'/></node>\n";
    for (int j = 0; j < joints; ++j)
        text += "<node id='j" + std::to_string(j) + "'><rotate sid='turn'>0 0 1 0</rotate></node>\n";
    return text;
}

const std::string& largeDocument() {
    static const std::string text = collada(sheet("mesh", 300) + animations(20, 5000) + scene(nodes(20)));
    return text;
}

std::vector<double> told(const std::string& text) {
    std::vector<double> shares;
    LoadOptions options;
    options.progress = [&](double share) { shares.push_back(share); };
    loadText(text, options);
    return shares;
}

double widestGap(const std::vector<double>& shares) {
    double widest = shares.front(), last = shares.front();
    for (const double share : shares) widest = std::max(widest, share - std::exchange(last, share));
    return widest;
}

TEST(LoadProgressTest, itRisesInManySmallStepsToOne) {
    for (const std::string& text : {largeDocument(), collada(sheet("mesh", 500) + scene(nodes(0))),
                                    collada(triangle() + animations(60, 3000) + scene(nodes(60))),
                                    collada(triangle() + scene(nodes(30'000)))}) {
        const std::vector<double> shares = told(text);
        ASSERT_FALSE(shares.empty());
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        EXPECT_THAT(shares, Each(AllOf(Ge(0.0), Le(1.0))));
        EXPECT_EQ(shares.back(), 1.0);
        EXPECT_EQ(std::count(shares.begin(), shares.end(), 1.0), 1);
        EXPECT_GE(shares.size(), 20u);
        EXPECT_LE(shares.size(), 200u);
        EXPECT_LE(widestGap(shares), 0.25);
    }
}

TEST(LoadProgressTest, aSmallDocumentGoesThroughItsStages) {
    const std::vector<double> shares = told(collada(triangle() + animations(1, 3) + scene(nodes(1))));
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GE(shares.size(), 5u);
    EXPECT_EQ(shares.back(), 1.0);
}

TEST(LoadProgressTest, aMeshInAnotherDocumentCountsAsWell) {
    const std::string part = collada(sheet("mesh", 300));
    std::vector<double> shares;
    LoadOptions options;
    options.resolver = [&](const std::string&) { return part; };
    options.progress = [&](double share) { shares.push_back(share); };
    loadText(collada(scene("<node><instance_geometry url='part.dae#mesh'/></node>")), options);
    EXPECT_GE(shares.size(), 10u);
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

// Each time that the caller is asked, in turn: everywhere it is the cancelling that ends the load.
TEST(LoadProgressTest, aLoadCanBeCancelledWhereverItAsks) {
    const std::string part = collada(sheet("mesh", 60));
    const std::string text =
        collada(animations(3, 200) + scene("<node><instance_geometry url='part.dae#mesh'/></node>"
                                           "<node id='j0'><rotate sid='turn'>0 0 1 0</rotate></node>"));
    LoadOptions options;
    options.resolver = [&](const std::string&) { return part; };
    int asked = 0;
    options.cancelled = [&] { return ++asked, false; };
    loadText(text, options);
    ASSERT_GT(asked, 10);
    for (int at = 1; at <= asked; ++at) {
        int count = 0, toldAfter = 0, askedAfter = 0;
        bool stopped = false;
        options.cancelled = [&] {
            askedAfter += stopped;
            return stopped = ++count == at;
        };
        options.progress = [&](double) { toldAfter += stopped; };
        try {
            loadText(text, options);
            ADD_FAILURE() << "cancelled at question " << at << ", and loaded";
        } catch (const LoadError& error) {
            EXPECT_TRUE(error.cancelled()) << at;
        }
        EXPECT_EQ(askedAfter + toldAfter, 0) << at;
    }
}

TEST(LoadProgressTest, aLongListIsLeftInItsMiddle) {
    LoadOptions options;
    int asked = 0;
    options.cancelled = [&] { return ++asked, false; };
    loadText(largeDocument(), options);
    EXPECT_GE(asked, 40) << "several megabytes of numbers are more than forty pieces of work";
}

}  // namespace
}  // namespace walkcycle
