// Loading, against what it cannot be faster than (reading, parsing the XML, parsing the numbers) and against other
// importers:  bench_load FILE... [--benchmark_...]

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <tinyxml2.h>

#include "Peers.h"
#include "loaders/text/NumberParser.h"
#include "loaders/text/NumberText.h"
#include "walkcycle/io/File.h"

namespace {

using namespace walkcycle;

constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 30;

using State = benchmark::State;

void countBytes(State& state, const std::string& file) {
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(readFile(file, kMaxBytes).size()));
}

void read(State& state, const std::string& file) {
    for (auto _ : state) benchmark::DoNotOptimize(readFile(file, kMaxBytes));
    countBytes(state, file);
}

// The whole document, as a loader on tinyxml2 that cuts nothing out has it.
void parseXml(State& state, const std::string& file) {
    const Bytes bytes = readFile(file, kMaxBytes);
    for (auto _ : state) {
        tinyxml2::XMLDocument document;
        document.Parse(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        benchmark::DoNotOptimize(document.RootElement());
    }
    countBytes(state, file);
}

// The text of every long list, read as single-precision numbers.
void parseAllNumbers(State& state, const std::string& file) {
    const Bytes bytes = readFile(file, kMaxBytes);
    const auto cut = cutNumberText({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (!cut) return state.SkipWithError("a document that cannot be cut");
    std::vector<float> values;
    std::vector<NumberFault> faults;
    for (auto _ : state)
        for (const std::optional<NumberText>& list : cut->texts) {
            values.clear();
            if (list) parseNumbers(list->text, values, faults);
            benchmark::DoNotOptimize(values.data());
        }
    countBytes(state, file);
}

void load(State& state, const std::string& file, const Importer& importer) {
    for (auto _ : state) importer.load(file);
    countBytes(state, file);
}

void registerAll(const std::string& file) {
    const std::string name = file.substr(file.rfind('/') + 1) + "/";
    const auto add = [&](const char* what, auto run) {
        benchmark::RegisterBenchmark((name + what).c_str(), run)
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime();
    };
    add("read", [=](State& state) { read(state, file); });
    add("tinyxml2", [=](State& state) { parseXml(state, file); });
    add("numbers", [=](State& state) { parseAllNumbers(state, file); });
    for (const Importer& importer : importers())
        add(importer.name, [=](State& state) { load(state, file, importer); });
}

}  // namespace

int main(int count, char** arguments) {
    benchmark::Initialize(&count, arguments);
    for (int i = 1; i < count; ++i) registerAll(arguments[i]);
    if (count < 2) registerAll(WALKCYCLE_SOURCE_DIR "/res/walker.dae");
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
