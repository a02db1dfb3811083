// Whole documents, ours and, where the environment names folders of them, other people's:
// WALKCYCLE_CTS_DIR (cases of the Khronos conformance suite) and WALKCYCLE_FILES_DIR (any files).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "walkcycle/animation/Animator.h"
#include "walkcycle/loaders/ColladaLoader.h"
#include "walkcycle/model/Bounds.h"
#include "walkcycle/model/CpuSkinning.h"

namespace walkcycle {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> documentsIn(const fs::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".dae") files.push_back(entry.path().string());
    }
    std::ranges::sort(files);
    return files;
}

std::vector<std::string> documents() {
    std::vector<std::string> files = documentsIn(fs::path(WALKCYCLE_SOURCE_DIR) / "res");
    for (const char* variable : {"WALKCYCLE_CTS_DIR", "WALKCYCLE_FILES_DIR"}) {
        const char* folder = std::getenv(variable);
        if (!folder) continue;
        const auto more = documentsIn(folder);
        files.insert(files.end(), more.begin(), more.end());
    }
    return files;
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::vector<glm::mat4> exactTransforms(const Model& model, double seconds, std::vector<float>& parameters) {
    std::vector<glm::dmat4> locals(model.skeleton.joints.size());
    std::vector<double> numbers(model.parameters.size());
    model.exactMotion->evaluate(seconds, locals, numbers);
    std::vector<glm::dmat4> exact(locals.size());
    for (std::size_t i = 0; i < locals.size(); ++i) {
        const int parent = model.skeleton.joints[i].parent;
        exact[i] = (parent == kNoParent ? glm::dmat4(model.skeleton.rootTransform)
                                        : exact[static_cast<std::size_t>(parent)]) *
                   locals[i];
    }
    parameters.assign(numbers.begin(), numbers.end());
    return {exact.begin(), exact.end()};
}

// The largest distance between vertices posed by the keys and by the file's own curves at one time.
float distanceAt(const Model& model, Animator& animator, double seconds) {
    std::vector<float> parameters;
    const auto exact = exactTransforms(model, seconds, parameters);
    animator.sampleAt(seconds);
    CpuSkinning skinning;
    std::vector<glm::vec3> played, meant;
    float largest = 0.0f;
    for (const MeshInstance& instance : model.instances) {
        skinning.positions(model, instance, animator.modelTransforms(), animator.parameters(), played);
        skinning.positions(model, instance, exact, parameters, meant);
        for (std::size_t p = 0; p < played.size(); ++p) {
            largest = std::max(largest, glm::length(played[p] - meant[p]));
        }
    }
    return largest;
}

}  // namespace

TEST(CorpusTest, everyDocumentLoadsWithFinitePositionsOrSaysWhyNot) {
    for (const std::string& file : documents()) {
        try {
            const Model model = loadCollada(file);
            for (const MeshData& mesh : model.meshes) {
                EXPECT_TRUE(std::ranges::all_of(mesh.positions, isFinite)) << file;
            }
        } catch (const LoadError& error) {
            EXPECT_FALSE(error.diagnostics.empty()) << file;
            EXPECT_THAT(error.what(), testing::HasSubstr("WC0")) << file;
        }
    }
}

TEST(CorpusTest, keyFramesFollowTheFilesOwnCurvesWithinTheTolerance) {
    for (const std::string& file : documents()) {
        try {
            LoadOptions options;
            options.loadImages = false;
            const Model model = loadCollada(file, options);
            if (!model.exactMotion || model.animations.empty()) continue;
            const Animation& clip = model.animations.front();
            Animator animator(model.skeleton, model.restParameters());
            animator.doAnimation(clip);
            const float size = animatedBounds(model, &clip).diagonal();
            for (int i = 0; i < 50; ++i) {  // uneven times, so as not to stand on keys
                const double seconds = clip.startSeconds + clip.lengthInSeconds() * (i + 0.37) / 50.0;
                EXPECT_LE(distanceAt(model, animator, seconds),
                          1.5 * options.tolerance * static_cast<double>(size))
                    << file << " at " << seconds << " s";
            }
        } catch (const LoadError&) {  // the test above has looked at it
        }
    }
}

}  // namespace walkcycle
