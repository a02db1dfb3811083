#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <zlib.h>

#include "loaders/AnimationText.h"
#include "loaders/LoadText.h"
#include "loaders/PaintedText.h"
#include "loaders/TestFiles.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// A document that costs `amount` of what a limit is for, and where it says so when that is too much.
struct Costly {
    std::string limit;
    std::uint64_t amount = 0;
    Bytes document;
    std::string element;  // the end of its path; empty: about the file as a whole
    FileResolver resolver{};
    const char* code = "WC0801";
};

std::string repeat(const std::string& text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) all += text;
    return all;
}

std::string padded(std::string text, std::size_t length) {
    text.resize(length, ' ');
    return text;
}

const std::string kDrawn = collada(triangle() + scene("<node><instance_geometry url='#mesh'/></node>"));

// One polygon of so many corners, each a vertex; the last three are a hole.
std::string polygon(std::size_t corners) {
    std::string positions, p;
    for (std::size_t i = 0; i < corners; ++i) {
        positions += std::to_string(i) + " " + std::to_string(i * i) + " 0 ";
        if (i + 3 < corners) p += std::to_string(i) + " ";
    }
    const std::string last =
        std::to_string(corners - 3) + " " + std::to_string(corners - 2) + " " + std::to_string(corners - 1);
    return collada(
        "<library_geometries><geometry id='mesh'><mesh>" + floatSource("at", positions) +
        "<vertices id='v'><input semantic='POSITION' source='#at'/></vertices>\n<polygons count='1'>"
        "<input semantic='VERTEX' source='#v' offset='0'/><ph><p>" +
        p + "</p><h>" + last + "</h></ph></polygons></mesh></geometry></library_geometries>" +
        scene("<node><instance_geometry url='#mesh'/></node>"));
}

std::string skinned(const SkinText& skin, const std::string& instances) {
    return collada(triangle() + controllers(skin.text()) +
                   scene("<node sid='hip'><node sid='knee'/></node><node>" + instances + "</node>"));
}

// A node of so many elements, shown twice: once as such, and once by reference.
std::string instanced(std::size_t elements) {
    return collada("<library_nodes><node id='many'>" + repeat("<translate>1 2 3</translate>", elements - 1) +
                   "</node></library_nodes>" + scene("<node><instance_node url='#many'/></node>"));
}

std::string moved(const AnimationText& animation) {
    return boxWith("<translate sid='t'>0 0 0</translate>", animations(animation.text()));
}

Bytes picture(int width) {
    Image image{.width = width, .height = 1, .hasAlpha = false, .rgba = {}};
    image.rgba.assign(static_cast<std::size_t>(width) * 4, 255);
    return encodePng(image);
}

std::optional<Bytes> pictureFor(const std::string&) {
    return picture(20);
}

Bytes packed(const std::string& text) {
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    Bytes out(text.size());
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = out.data();
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

std::optional<Bytes> anotherDocument(const std::string&) {
    return bytesOf(collada("<library_nodes><node id='n'/></library_nodes>"));
}

std::vector<Costly> documents() {
    SkinText pulled;
    pulled.vcount = "5 1 1";
    pulled.v = "0 0 0 0 0 0 1 0 1 0  0 0  1 0";
    const std::string skins = repeat("<instance_controller url='#skin'/>", 2);
    AnimationText wide{.target = "box/t", .times = "0", .values = "1 2 3 4 5 6 7 8 9", .params = "ABCDEFGHI"};
    AnimationText zigzag{.target = "box/t.Y", .times = "0 1 2 3 4 5 6", .values = "0 5 0 5 0 5 0"};
    AnimationText other{.target = "box/t.X", .times = "0 1 2 3 4 5 6", .values = "0 5 0 5 0 5 0"};
    const std::string zeros = padded(kDrawn, std::size_t{2} << 20);
    const Bytes bomb = packed(zeros);
    const std::uint64_t ratio = (zeros.size() + bomb.size() - 1) / bomb.size();
    std::string others;
    for (int i = 0; i < 5; ++i)
        others += "<node><instance_node url='" + std::to_string(i) + ".dae#n'/></node>\n";
    return {
        {"file-bytes", kDrawn.size(), bytesOf(kDrawn), ""},
        {"elements", 28, bytesOf(collada("<!-- a comment -->" + scene(repeat("<node/>", 19)))), ""},
        {"nesting",
         13,
         bytesOf(collada(scene(repeat("<node>", 10) + repeat("</node>", 10)))),
         "node",
         {},
         "WC0104"},
        {"numbers", 15,
         bytesOf(collada(triangle("mesh", "0 0 0 1 0 0 0 1 0 1 1 1 2 2 2") +
                         scene("<node><instance_geometry url='#mesh'/></node>"))),
         "float_array[id=mesh-positions-array]"},
        {"positions", 6, bytesOf(skinned({}, skins)), "controller[id=skin]"},
        {"vertices", 6,
         bytesOf(collada(triangle() + scene(repeat("<node><instance_geometry url='#mesh'/></node>", 2)))),
         "instance_geometry"},
        {"polygon-corners", 9, bytesOf(polygon(9)), "polygons"},
        {"influences", 5, bytesOf(skinned(pulled, skins)), "vcount"},
        {"skin-joints", 6, bytesOf(skinned({}, skins)), "instance_controller"},
        {"nodes", 7, bytesOf(collada(scene(repeat("<node/>", 7)))), "node"},
        {"scene-depth", 4,
         bytesOf(collada("<library_nodes><node id='deep'><node id='deepest'/></node></library_nodes>" +
                         scene("<node><node><instance_node url='#deep'/></node></node>"))),
         "node[id=deepest]"},
        {"node-text", 12, bytesOf(collada(scene("<node id='four'/><node id='two' name='a b' sid='xy'/>"))),
         "node[id=two]"},
        {"instanced-elements", 9, bytesOf(instanced(9)), "node[id=many]"},
        {"instances", 3,
         bytesOf(collada(triangle() +
                         scene("<node>" + repeat("<instance_geometry url='#mesh'/>", 3) + "</node>"))),
         "instance_geometry"},
        {"key-numbers", 10, bytesOf(moved(wide)), "sampler[id=anim-sampler]"},
        {"key-frames", 7, bytesOf(moved(zigzag)), "COLLADA"},
        {"documents", 5, bytesOf(collada(scene(others))), "instance_node", anotherDocument},
        {"image-dimension", 20, bytesOf(withPictures(1)), "image[id=i0]/init_from", pictureFor, "WC0803"},
        {"image-pixels", 20, bytesOf(withPictures(1)), "image[id=i0]/init_from", pictureFor, "WC0803"},
        {"total-pixels", 60, bytesOf(withPictures(3)), "image[id=i2]/init_from", pictureFor, "WC0803"},
        {"archive-bytes", kDrawn.size() + 5, zipOf({{"a.dae", kDrawn}, {"b.png", "bytes"}}), ""},
        {"archive-bytes", kDrawn.size(), gzipOf(kDrawn), ""},
        {"archive-entries", 3, zipOf({{"a.dae", kDrawn}, {"b.png", ""}, {"c.png", ""}}), ""},
        {"archive-ratio", ratio, bomb, ""},
    };
}

// All that a load says with a limit set, whether or not it gives a model.
std::vector<Diagnostic> saidWith(const Costly& costly, std::uint64_t value) {
    LoadOptions options;
    options.limits.*findLimit(costly.limit)->value = value;
    options.resolver = costly.resolver;
    try {
        return loadCollada(costly.document, "test.dae", options).diagnostics;
    } catch (const LoadError& error) {
        return error.diagnostics;
    }
}

std::vector<Diagnostic> saidOfLimit(const Costly& costly, std::uint64_t value) {
    std::vector<Diagnostic> said = saidWith(costly, value);
    std::erase_if(said, [&](const Diagnostic& diagnostic) { return diagnostic.code != costly.code; });
    return said;
}

TEST(LimitsTest, eachLimitHoldsWhereItSaysAndTheMessageTellsWhatWhereAndHowToRaiseIt) {
    for (const Costly& costly : documents()) {
        SCOPED_TRACE(costly.limit);
        EXPECT_THAT(saidOfLimit(costly, costly.amount + 1), IsEmpty()) << "one below the limit";
        EXPECT_THAT(saidOfLimit(costly, costly.amount), IsEmpty()) << "at the limit";
        const std::vector<Diagnostic> over = saidOfLimit(costly, costly.amount - 1);
        ASSERT_THAT(over, SizeIs(1)) << "one over the limit";
        const std::string setting = costly.limit + "=" + std::to_string(costly.amount - 1);
        EXPECT_THAT(over[0].message, HasSubstr(setting));
        EXPECT_THAT(over[0].elementPath, testing::EndsWith(costly.element));
        EXPECT_TRUE(costly.element.empty() || over[0].line > 0);
        if (costly.limit == "nesting") continue;  // cannot be raised
        EXPECT_THAT(over[0].message, HasSubstr(std::to_string(costly.amount) + " "));
        EXPECT_THAT(over[0].cure, HasSubstr("raise the limit '" + costly.limit + "'"));
    }
}

TEST(LimitsTest, noLimitIsWithoutADocumentThatReachesIt) {
    std::set<std::string> tested{"messages"};  // below
    for (const Costly& costly : documents()) tested.insert(costly.limit);
    for (const LimitInfo& limit : kLimits)
        EXPECT_TRUE(tested.contains(std::string(limit.name))) << limit.name;
}

TEST(LimitsTest, afterTheLimitOfMessagesTheRestIsCounted) {
    std::string elements;
    for (int i = 0; i < 20; ++i) elements += "<e" + std::to_string(i) + "/>";
    TestLoad load(collada(elements));
    for (const std::size_t number : {7u, 8u, 9u, 20u}) {
        Diagnostics diagnostics(8);
        std::size_t reported = 0;
        for (XmlNode element : load.collada.children())
            if (element.is("asset") || reported++ < number)
                diagnostics.report(Code::MissingAttribute, element, {std::string(element.name()), "id"});
        std::size_t counted = 0;
        for (const Diagnostic& diagnostic : diagnostics.all())
            counted += 1 + static_cast<std::size_t>(diagnostic.repeats);
        EXPECT_EQ(counted, number + 1) << "none is lost";
        EXPECT_THAT(diagnostics.all(), SizeIs(std::min<std::size_t>(number + 1, 8 + 3)));
    }
}

TEST(LimitsTest, theXmlReadersOwnDepthIsTheLimitOfNesting) {
    const auto nested = [](std::size_t levels) {
        return collada(scene(repeat("<node>", levels - 3) + repeat("</node>", levels - 3)));
    };
    EXPECT_EQ(loadText(nested(97)).skeleton.joints.size(), 94u);
    EXPECT_EQ(loadText(nested(98)).skeleton.joints.size(), 95u);
    EXPECT_THAT(whyNot(nested(99)).message, HasSubstr("nesting=98"));
}

TEST(LimitsTest, instancesWithinInstancesMultiplyAndStop) {
    std::string levels = "<node id='n0'>" + repeat("<instance_geometry url='#mesh'/>", 1000) + "</node>";
    for (int i = 1; i < 40; ++i) {
        const std::string next = "<instance_node url='#n" + std::to_string(i - 1) + "'/>";
        levels += "<node id='n" + std::to_string(i) + "'>" + next + next + "</node>";
    }
    const std::string text = collada(triangle() + "<library_nodes>" + levels + "</library_nodes>" +
                                     scene("<node><instance_node url='#n39'/></node>"));
    EXPECT_THAT(whyNot(text).message, HasSubstr("instanced-elements="));
}

TEST(LimitsTest, manyMeshesSkinsAndMorphsOfOneLongSourceAreTooMany) {
    std::string positions = repeat("1 2 3 ", 1000), geometries, skins, nodes;
    std::string first = triangle("g", positions);
    for (int i = 0; i < 20; ++i) {
        const std::string n = std::to_string(i);
        geometries += "<library_geometries><geometry id='h" + n + "'><mesh><vertices id='hv" + n +
                      "'><input semantic='POSITION' source='#g-positions'/>"
                      "</vertices><triangles count='1'><input semantic='VERTEX' source='#hv" +
                      n + "' offset='0'/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>";
        nodes += "<node><instance_geometry url='#h" + n + "'/></node>";
    }
    const std::string text = collada(first + geometries + scene(nodes));
    LoadOptions options;
    options.limits.maxPositions = 20'000;
    EXPECT_EQ(loadText(text, options).instances.size(), 20u);
    options.limits.maxPositions = 19'999;
    EXPECT_THAT(whyNot(text, options), says("WC0801", lineOf(text, "<geometry id='h19'"),
                                            "COLLADA/library_geometries/geometry[id=h19]"));
}

TEST(LimitsTest, whatIsWrittenInComplicatedWaysIsCountedAsItIs) {
    const std::string odd =
        "<?xml version='1.0'?><!-- <a><b/> --><COLLADA version='1.4.1'><extra><![CDATA[<c/>]]></extra>"
        "<library_visual_scenes><visual_scene id='s'><node/></visual_scene></library_visual_scenes>"
        "<scene><instance_visual_scene url='#s'/></scene></COLLADA>";
    LoadOptions options;
    options.limits.maxElements = 9;  // seven elements, a comment, and a CDATA section
    EXPECT_NO_THROW(loadText(odd, options));
    options.limits.maxElements = 8;
    EXPECT_EQ(whyNot(odd, options).code, "WC0801");
}

}  // namespace
}  // namespace walkcycle
