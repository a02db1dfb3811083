// Sampling a clip, walking the hierarchy and making the palette, per character:  bench_pose [FILE] [--benchmark_...]
// pose/series is the way of the videos, pose/animator ours for one character, pose/crowd ours for many.

#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "SeriesAnimator.h"
#include "walkcycle/animation/Animator.h"
#include "walkcycle/crowd/CrowdPoser.h"
#include "walkcycle/loaders/ColladaLoader.h"

namespace {

using namespace walkcycle;

constexpr double kFrame = 1.0 / 60.0;
constexpr double kGolden = 0.6180339887;  // spreads the characters' times over the clip

const Model* model = nullptr;

std::vector<double> spreadTimes(std::int64_t count, double length) {
    std::vector<double> times;
    for (std::int64_t i = 0; i < count; ++i)
        times.push_back(loop(static_cast<double>(i) * kGolden, 1.0) * length);
    return times;
}

void animator(benchmark::State& state) {
    const Animation& clip = model->animations.front();
    const Skin& skin = model->skins.front();
    Animator animator(model->skeleton);
    animator.doAnimation(clip);
    std::vector<double> times = spreadTimes(state.range(0), clip.lengthInSeconds());
    std::vector<glm::mat4> palette;
    std::vector<JointRows> palettes(times.size() * skin.joints.size());
    for (auto _ : state) {
        auto next = palettes.begin();
        for (double& time : times) {
            animator.setTime(time += kFrame);
            computePalette(skin, animator.modelTransforms(), palette);
            for (const glm::mat4& matrix : palette) *next++ = JointRows(matrix);
        }
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

// {characters, threads}. The time that passes, not the processors' time: what more threads are for.
void crowd(benchmark::State& state) {
    CrowdPoser poser(model->skeleton, model->animations.front(), model->skins.front(),
                     static_cast<unsigned int>(state.range(1)));
    std::vector<double> times = spreadTimes(state.range(0), poser.lengthInSeconds());
    std::vector<JointRows> palettes(times.size() * poser.paletteSize());
    for (auto _ : state) {
        for (double& time : times) time += kFrame;
        poser.pose(times, palettes);
        benchmark::ClobberMemory();
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
    benchmark::RegisterBenchmark("pose/animator", animator)->Arg(1)->Arg(10'000);
    benchmark::RegisterBenchmark("pose/crowd", crowd)
        ->Args({1, 1})
        ->Args({100, 1})
        ->Args({10'000, 1})
        ->Args({10'000, 2})
        ->UseRealTime()
        ->MeasureProcessCPUTime();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
