#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "Layering.h"
#include "SourceTree.h"

using namespace walkcycle::house;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

namespace {

std::vector<SourceFile> sourceFiles() {
    std::vector<SourceFile> files;
    for (const char* folder : {"include", "src"})
        for (const std::string& path : filesBelow(folder, {".h", ".cpp", ".inc"}))
            files.push_back({path, readText(root() / path)});
    return files;
}

std::vector<std::string> faultsOf(const std::string& path, const std::string& included) {
    return layeringFaults({path, "#include " + included + "\n"});
}

}  // namespace

TEST(LayeringTest, everyIncludePointsTheRightWay) {
    const auto files = sourceFiles();
    ASSERT_THAT(files, Not(IsEmpty()));
    for (const SourceFile& file : files) EXPECT_THAT(layeringFaults(file), IsEmpty());
}

TEST(LayeringTest, noFilesIncludeEachOtherInACircle) {
    EXPECT_THAT(circles(sourceFiles()), IsEmpty());
}

TEST(LayeringTest, anIncludeThatPointsTheWrongWayIsNamedWithItsLine) {
    EXPECT_THAT(
        layeringFaults({"src/animation/Pose.cpp", "// a comment\n#include \"walkcycle/model/Model.h\"\n"}),
        ElementsAre("src/animation/Pose.cpp:2: animation may not include include/walkcycle/model/Model.h"));
    EXPECT_THAT(faultsOf("src/loaders/ColladaLoader.cpp", "\"render/Vao.h\""), Not(IsEmpty()));
    EXPECT_THAT(faultsOf("src/render/A.cpp", "\"walkcycle/loaders/ColladaLoader.h\""), Not(IsEmpty()));
    EXPECT_THAT(faultsOf("src/io/A.cpp", "\"walkcycle/model/Model.h\""), Not(IsEmpty()));
}

TEST(LayeringTest, theRoomsOfTheLoadersPointOneWay) {
    EXPECT_THAT(faultsOf("src/loaders/curves/Curve.cpp", "\"loaders/scene/SceneGraph.h\""), IsEmpty());
    EXPECT_THAT(faultsOf("src/loaders/scene/SceneGraph.h", "\"loaders/curves/Curve.h\""), Not(IsEmpty()));
    EXPECT_THAT(faultsOf("src/loaders/geometry/A.h", "\"loaders/materials/Tangents.h\""), Not(IsEmpty()));
    EXPECT_THAT(faultsOf("src/loaders/nowhere/A.h", "\"loaders/text/Markup.h\""), Not(IsEmpty()));
}

TEST(LayeringTest, aRoomIsEnteredThroughItsDoors) {
    EXPECT_THAT(faultsOf("src/loaders/text/Markup.cpp", "\"loaders/text/PlainNumber.h\""), IsEmpty());
    EXPECT_THAT(faultsOf("src/loaders/document/XmlNode.cpp", "\"loaders/text/NumberParser.h\""), IsEmpty());
    EXPECT_THAT(faultsOf("src/loaders/document/XmlNode.cpp", "\"loaders/text/PlainNumber.h\""),
                Not(IsEmpty()));
}

TEST(LayeringTest, aPublicHeaderStandsOnPublicHeadersAndGlmAlone) {
    EXPECT_THAT(faultsOf("include/walkcycle/model/A.h", "<walkcycle/animation/Joint.h>"), IsEmpty());
    EXPECT_THAT(faultsOf("include/walkcycle/model/A.h", "<glm/vec3.hpp>"), IsEmpty());
    EXPECT_THAT(faultsOf("include/walkcycle/model/A.h", "\"model/SkinningKernel.h\""), Not(IsEmpty()));
    EXPECT_THAT(faultsOf("include/walkcycle/render/A.h", "<epoxy/gl.h>"), Not(IsEmpty()));
}

// <X11/Xlib.h>, which <EGL/egl.h> includes, defines these as macros.
TEST(LayeringTest, noPublicHeaderUsesAWordThatX11Defines) {
    const std::regex word(
        "\\b(None|Always|Bool|Status|True|False|Success|Complex|Above|Below|Unsorted|"
        "KeyPress|KeyRelease|FocusIn|FocusOut)\\b");
    for (const std::string& path : filesBelow("include", {".h"})) {
        const std::string code = std::regex_replace(readText(root() / path), std::regex("//[^\n]*"), "");
        EXPECT_FALSE(std::regex_search(code, word)) << path;
    }
}

TEST(LayeringTest, thePublicFaceStaysSmall) {
    EXPECT_THAT(filesBelow("include", {".h"}), SizeIs(testing::Le(40)));
}

TEST(LayeringTest, aModelHoldsPicturesButReadsNoFiles) {
    EXPECT_THAT(faultsOf("include/walkcycle/model/Material.h", "<walkcycle/io/Image.h>"), IsEmpty());
    EXPECT_THAT(faultsOf("include/walkcycle/model/Material.h", "<walkcycle/io/File.h>"), Not(IsEmpty()));
}

TEST(LayeringTest, aLibraryStaysInItsFolder) {
    EXPECT_THAT(faultsOf("src/loaders/document/XmlNode.cpp", "<tinyxml2.h>"), IsEmpty());
    EXPECT_THAT(faultsOf("src/model/A.h", "<tinyxml2.h>"), Not(IsEmpty()));
    EXPECT_THAT(faultsOf("src/loaders/ColladaLoader.cpp", "<epoxy/gl.h>"), Not(IsEmpty()));
    EXPECT_THAT(faultsOf("src/render/A.cpp", "<stb/stb_image.h>"), Not(IsEmpty()));
}

TEST(LayeringTest, aCircleIsFoundAlsoThroughASource) {
    const std::vector<SourceFile> files = {{"src/model/A.h", "#include \"model/B.h\"\n"},
                                           {"src/model/B.h", ""},
                                           {"src/model/B.cpp", "#include \"model/C.h\"\n"},
                                           {"src/model/C.h", "#include \"model/A.h\"\n"}};
    EXPECT_THAT(circles(files), ElementsAre("model/A -> model/B -> model/C -> model/A"));
    EXPECT_THAT(circles({{"src/model/A.h", ""}, {"src/model/A.cpp", "#include \"model/A.h\"\n"}}), IsEmpty());
}
