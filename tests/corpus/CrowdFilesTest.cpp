#include <filesystem>
#include <vector>

#include "crowd/PoserAgreement.h"
#include "walkcycle/loaders/ColladaLoader.h"

namespace walkcycle {
namespace {

// The built-in character and every fixture that has a skin and a clip: what they move is as varied as files are.
TEST(CrowdFilesTest, everyClipOfEverySkinAgreesWithThePlainWay) {
    std::vector<std::filesystem::path> files{WALKCYCLE_SOURCE_DIR "/res/walker.dae"};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(WALKCYCLE_FIXTURES))
        if (entry.path().extension() == ".dae") files.push_back(entry.path());
    LoadOptions options;
    options.loadImages = false;
    int posed = 0;
    for (const std::filesystem::path& file : files) {
        SCOPED_TRACE(file.string());
        Model model;
        try {
            model = loadCollada(file.string(), options);
        } catch (const LoadError&) {
            continue;
        }
        for (const Animation& clip : model.animations)
            for (const Skin& skin : model.skins)
                expectFastAgreesWithPlain(model.skeleton, clip, skin), ++posed;
    }
    EXPECT_GE(posed, 3);
}

}  // namespace
}  // namespace walkcycle
