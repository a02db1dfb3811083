#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/TestFiles.h"
#include "walkcycle/io/File.h"
#include "walkcycle/loaders/LoadOptions.h"

namespace walkcycle {
namespace {

using ::testing::Each;
using ::testing::Key;
using ::testing::Pair;

const std::string kPart = collada(triangle());
const std::string kRoot = collada(scene("<node><instance_geometry url='part.dae#mesh'/></node>"));

std::size_t instancesWith(FileResolver resolver) {
    LoadOptions options;
    options.resolver = std::move(resolver);
    return loadText(kRoot, options).instances.size();
}

template <typename Container>
Container contents() {
    Container bytes(kPart.size());
    std::memcpy(bytes.data(), kPart.data(), kPart.size());
    return bytes;
}

TEST(FileResolverTest, anyContiguousBytesWillDo) {
    const auto asVector = [](const std::string&) { return contents<std::vector<std::uint8_t>>(); };
    const auto asChars = [](const std::string&) { return contents<std::vector<char>>(); };
    const auto asStdBytes = [](const std::string&) { return contents<std::vector<std::byte>>(); };
    const auto asString = [](const std::string&) { return kPart; };
    const auto asView = [](const std::string&) { return std::string_view(kPart); };
    const auto asSpan = [](const std::string&) { return std::span<const char>(kPart); };
    const auto asOwn = [](const std::string&) { return contents<Bytes>(); };
    const auto asOptional = [](const std::string&) { return std::optional<std::string>(kPart); };
    for (const FileResolver& resolver :
         {FileResolver(asVector), FileResolver(asChars), FileResolver(asStdBytes), FileResolver(asString),
          FileResolver(asView), FileResolver(asSpan), FileResolver(asOwn), FileResolver(asOptional)})
        EXPECT_EQ(instancesWith(resolver), 1u);
}

TEST(FileResolverTest, nothingIsNoFileAndAnEmptyOneIsAFile) {
    EXPECT_EQ(instancesWith([](const std::string&) { return std::nullopt; }), 0u);
    EXPECT_FALSE(ResolvedFile(std::optional<std::string>()).found());
    EXPECT_TRUE(ResolvedFile(std::string()).found());
    EXPECT_TRUE(ResolvedFile(std::string()).bytes().empty());
}

// Several textures and guesses come by one path: a document, a picture that is there, and one that is not.
TEST(FileResolverTest, eachPathIsAskedForOnce) {
    const std::string images =
        "<library_images><image id='a'><init_from>a.png</init_from></image>"
        "<image id='b'><init_from>./a.png</init_from></image><image "
        "id='c'><init_from>maps/../a.png</init_from>"
        "</image><image id='d'><init_from>gone.png</init_from></image>"
        "<image id='e'><init_from>./gone.png</init_from></image></library_images>\n";
    std::string effects, materials, bound, nodes;
    for (const std::string id : {"a", "b", "c", "d", "e"}) {
        effects += "<effect id='e" + id +
                   "'><profile_COMMON><technique sid='t'><lambert><diffuse><texture texture='" + id +
                   "' texcoord='UV'/></diffuse></lambert></technique></profile_COMMON></effect>";
        materials += "<material id='m" + id + "'><instance_effect url='#e" + id + "'/></material>";
        nodes +=
            "<node><instance_geometry url='part.dae#mesh'><bind_material><technique_common>"
            "<instance_material symbol='' target='#m" +
            id + "'/></technique_common></bind_material></instance_geometry></node>";
    }
    const std::string text =
        collada(images + "<library_effects>" + effects + "</library_effects><library_materials>" + materials +
                "</library_materials>" + scene(nodes));
    std::map<std::string, int> asked;
    LoadOptions options;
    options.texture = "";
    options.resolver = [&](const std::string& path) -> std::optional<std::string> {
        ++asked[path];
        if (path == "part.dae") return kPart;
        if (path == "a.png") return "not a picture";
        return std::nullopt;
    };
    loadText(text, options);
    EXPECT_THAT(asked, testing::Contains(Key("a.png")));
    EXPECT_THAT(asked, testing::Contains(Key("gone.png")));
    EXPECT_THAT(asked, Each(Pair(testing::_, 1)));
}

// As of a resolver that returns readFile(path).
TEST(FileResolverTest, aFileErrorIsReportedOnceAndThePathNotAskedForAgain) {
    const std::string text = collada(
        "<library_images><image id='a'><init_from>a.png</init_from></image></library_images>"
        "<library_effects><effect id='e'><profile_COMMON><technique sid='t'><lambert><diffuse><texture "
        "texture='a' texcoord='UV'/></diffuse></lambert></technique></profile_COMMON></effect>"
        "</library_effects><library_materials><material id='m'><instance_effect url='#e'/></material>"
        "</library_materials>" +
        scene("<node><instance_geometry url='part.dae#mesh'><bind_material><technique_common>"
              "<instance_material symbol='' target='#m'/></technique_common></bind_material>"
              "</instance_geometry></node>"));
    std::map<std::string, int> asked;
    LoadOptions options;
    options.resolver = [&](const std::string& path) -> std::string {
        ++asked[path];
        if (path == "part.dae") return kPart;
        throw FileError("cannot read '" + path + "': the disk is gone");
    };
    const std::vector<std::string> reported = codes(loadText(text, options).diagnostics);
    EXPECT_EQ(std::count(reported.begin(), reported.end(), "WC0624"), 1);
    EXPECT_THAT(reported, testing::Not(testing::Contains("WC0620")));
    EXPECT_THAT(asked, testing::Contains(Key("a.png")));
    EXPECT_THAT(asked, Each(Pair(testing::_, 1)));
}

TEST(FileResolverTest, theUsersTextureIsAskedForToo) {
    std::vector<std::string> asked;
    LoadOptions options;
    options.texture = "skins/blue.png";
    options.resolver = [&](const std::string& path) -> std::optional<std::string> {
        asked.push_back(path);
        if (path == "part.dae") return kPart;
        return std::nullopt;
    };
    const std::string text = collada(
        "<library_effects><effect id='e'><profile_COMMON><technique sid='t'><lambert><diffuse><texture "
        "texture='x' "
        "texcoord='UV'/></diffuse></lambert></technique></profile_COMMON></effect></library_effects>"
        "<library_materials><material id='m'><instance_effect url='#e'/></material></library_materials>" +
        scene("<node><instance_geometry "
              "url='part.dae#mesh'><bind_material><technique_common><instance_material "
              "symbol='' target='#m'/></technique_common></bind_material></instance_geometry></node>"));
    const Model model = loadText(text, options);
    EXPECT_THAT(asked, testing::Contains("skins/blue.png"));
    EXPECT_THAT(codes(model.diagnostics), testing::Contains("WC0620"));
}

TEST(FileResolverTest, whatItThrowsReachesTheCaller) {
    EXPECT_THROW(instancesWith([](const std::string&) -> std::string { throw std::domain_error("no"); }),
                 std::domain_error);
}

}  // namespace
}  // namespace walkcycle
