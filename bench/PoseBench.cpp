// Sampling a clip, walking the hierarchy and making the palette, per character:  bench_pose [FILE] [--benchmark_...]
// pose/series is the way of the videos; the other two are walkcycle's two types.

#include <benchmark/benchmark.h>

#include "SeriesAnimator.h"
#include "animation/CrowdPoser.h"
#include "animation/FastPoser.h"
#include "animation/PlainPoser.h"
#include "loaders/ColladaLoader.h"

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

template <class Poser>
void characters(benchmark::State& state) {
    Poser poser(model->skeleton, model->animations.front(), model->skins.front());
    std::vector<double> times = spreadTimes(state.range(0), poser.lengthInSeconds());
    std::vector<JointRows> palettes(times.size() * poser.paletteSize());
    for (auto _ : state) {
        for (std::size_t i = 0; i < times.size(); ++i) {
            times[i] += kFrame;
            poser.pose(times[i], std::span(palettes).subspan(i * poser.paletteSize(), poser.paletteSize()));
        }
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

// The time that passes, not the processors' time: what more threads are for.
void crowd(benchmark::State& state) {
    const FastPoser poser(model->skeleton, model->animations.front(), model->skins.front());
    CrowdPoser crowd(poser, static_cast<unsigned int>(state.range(0)));
    std::vector<double> times = spreadTimes(10'000, poser.lengthInSeconds());
    std::vector<JointRows> palettes(times.size() * poser.paletteSize());
    for (auto _ : state) {
        for (double& time : times) time += kFrame;
        crowd.pose(times, palettes);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(times.size()));
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
    benchmark::RegisterBenchmark("pose/plain", characters<PlainPoser>)->Arg(1)->Arg(10'000);
    benchmark::RegisterBenchmark("pose/fast", characters<FastPoser>)->Arg(1)->Arg(100)->Arg(10'000);
    benchmark::RegisterBenchmark("crowd/threads", crowd)
        ->Arg(1)
        ->Arg(2)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
