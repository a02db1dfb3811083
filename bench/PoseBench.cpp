// Sampling a clip, walking the hierarchy and making the palette, per character:  bench_pose [FILE] [--benchmark_...]

#include <benchmark/benchmark.h>

#include "SeriesAnimator.h"
#include "animation/Animator.h"
#include "animation/Skin.h"
#include "loaders/ColladaLoader.h"

namespace {

using namespace walkcycle;

constexpr double kFrame = 1.0 / 60.0;
constexpr double kGolden = 0.6180339887;  // spreads the characters' times over the clip

const Model* model = nullptr;

void characters(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const std::vector<float> rest = model->restParameters();
    std::vector<Animator> animators(count, Animator(model->skeleton, rest));
    std::vector<std::vector<glm::mat4>> palettes(count);
    for (std::size_t i = 0; i < count; ++i) {
        animators[i].doAnimation(model->animations.front());
        animators[i].setTime(static_cast<double>(i) * kGolden);
    }
    for (auto _ : state) {
        for (std::size_t i = 0; i < count; ++i) {
            animators[i].update(kFrame);
            computePalette(model->skins.front(), animators[i].modelTransforms(), palettes[i]);
            benchmark::DoNotOptimize(palettes[i].data());
        }
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void theSeriesWay(benchmark::State& state) {
    const Animation& clip = model->animations.front();
    bench::SeriesAnimator animator(*model, clip, static_cast<int>(clip.lengthInSeconds() * 24.0) + 2);
    double time = 0.0;
    for (auto _ : state) {
        time = loop(time + kFrame, clip.lengthInSeconds());
        animator.setTime(time);
        benchmark::DoNotOptimize(animator.update().data());
    }
    state.SetItemsProcessed(state.iterations());
}

}  // namespace

int main(int count, char** arguments) {
    benchmark::Initialize(&count, arguments);
    const Model loaded = loadCollada(count > 1 ? arguments[1] : WALKCYCLE_SOURCE_DIR "/res/walker.dae");
    if (loaded.animations.empty() || loaded.skins.empty()) return 1;
    model = &loaded;
    benchmark::RegisterBenchmark("pose/series", theSeriesWay);
    benchmark::RegisterBenchmark("pose/walkcycle", characters)->Arg(1)->Arg(100)->Arg(10'000);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
