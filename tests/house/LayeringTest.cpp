#include <gmock/gmock.h>

#include "Layering.h"
#include "SourceTree.h"

using namespace walkcycle::house;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

TEST(LayeringTest, everyIncludeOfTheSourcesPointsTheRightWay) {
    const auto files = filesBelow("src", {".h", ".cpp", ".inc"});
    ASSERT_THAT(files, Not(IsEmpty()));
    for (const std::string& file : files) {
        EXPECT_THAT(layeringFaults(file, readText(root() / file)), IsEmpty());
    }
}

TEST(LayeringTest, anIncludeThatPointsTheWrongWayIsNamedWithItsLine) {
    EXPECT_THAT(layeringFaults("src/animation/Pose.cpp", "// a comment\n#include \"model/Model.h\"\n"),
                ElementsAre("src/animation/Pose.cpp:2: animation may not include model/Model.h"));
    EXPECT_THAT(layeringFaults("src/loaders/A.cpp", "#include \"render/Vao.h\"\n"), Not(IsEmpty()));
    EXPECT_THAT(layeringFaults("src/render/A.cpp", "# include \"loaders/ColladaLoader.h\"\n"),
                Not(IsEmpty()));
    EXPECT_THAT(layeringFaults("src/io/A.cpp", "#include \"model/Model.h\"\n"), Not(IsEmpty()));
}

TEST(LayeringTest, aModelHoldsPicturesButReadsNoFiles) {
    EXPECT_THAT(layeringFaults("include/walkcycle/model/Material.h", "#include \"io/Image.h\"\n"), IsEmpty());
    EXPECT_THAT(layeringFaults("include/walkcycle/model/Material.h", "#include \"io/File.h\"\n"),
                Not(IsEmpty()));
}

TEST(LayeringTest, aLibraryStaysInItsFolder) {
    EXPECT_THAT(layeringFaults("src/loaders/document/XmlNode.cpp", "#include <tinyxml2.h>\n"), IsEmpty());
    EXPECT_THAT(layeringFaults("src/model/A.h", "#include <tinyxml2.h>\n"), Not(IsEmpty()));
    EXPECT_THAT(layeringFaults("src/loaders/A.cpp", "#include <epoxy/gl.h>\n"), Not(IsEmpty()));
    EXPECT_THAT(layeringFaults("src/render/A.cpp", "#include <stb/stb_image.h>\n"), Not(IsEmpty()));
}
