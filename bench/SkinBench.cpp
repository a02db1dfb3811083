// Skinning on the CPU, against a copy of the bytes that it reads and writes:  bench_skin [FILE] [--benchmark_...]

#include <cstring>

#include <benchmark/benchmark.h>

#include "animation/Animator.h"
#include "loaders/ColladaLoader.h"
#include "model/CpuSkinning.h"

namespace {

using namespace walkcycle;

const Model* model = nullptr;

// Position and normal in, position and normal out, and four influences.
constexpr std::size_t kBytesPerVertex = 4 * sizeof(glm::vec3) + 4 * sizeof(Influence);

std::size_t vertices() {
    return model->meshes[static_cast<std::size_t>(model->instances.front().mesh)].vertexCount();
}

void copy(benchmark::State& state) {
    std::vector<char> from(vertices() * kBytesPerVertex / 2, 1), to(from.size());
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), from.size());
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(vertices()));
}

void skin(benchmark::State& state) {
    const std::vector<float> rest = model->restParameters();
    Animator animator(model->skeleton, rest);
    animator.doAnimation(model->animations.front());
    animator.setTime(0.4);
    CpuSkinning skinning;
    std::vector<glm::vec3> positions, normals;
    for (auto _ : state) {
        skinning.vertices(*model, model->instances.front(), animator.modelTransforms(), animator.parameters(),
                          positions, normals);
        benchmark::DoNotOptimize(positions.data());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(vertices()));
}

}  // namespace

int main(int count, char** arguments) {
    benchmark::Initialize(&count, arguments);
    const Model loaded = loadCollada(count > 1 ? arguments[1] : WALKCYCLE_SOURCE_DIR "/res/walker.dae");
    if (loaded.animations.empty() || loaded.instances.empty()) return 1;
    model = &loaded;
    benchmark::RegisterBenchmark("skin/copy", copy);
    benchmark::RegisterBenchmark("skin/walkcycle", skin);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
