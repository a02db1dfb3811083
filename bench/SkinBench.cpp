// Skinning on the processor, against a copy of the bytes that it reads (position, normal, four influences):
//   bench_skin [--benchmark_...]
// A mesh of 2,000 vertices, whose bytes fit into the cache, each vertex with its own position and four influences.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>
#include <glm/gtc/matrix_transform.hpp>

#include "model/SkinningKernel.h"

namespace {

using namespace walkcycle;

constexpr std::size_t kVertices = 2'000, kJoints = 60, kInfluences = 4;

struct Mesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint32_t> vertexPositions;
    Influences influences;
    std::vector<glm::mat4> palette;

    Mesh() {
        std::mt19937 engine(1);
        std::uniform_real_distribution<float> number(-1.0f, 1.0f);
        for (std::size_t i = 0; i < kJoints; ++i)
            palette.push_back(
                glm::rotate(glm::translate(glm::mat4(1.0f), {number(engine), number(engine), 0.0f}),
                            number(engine), glm::vec3(0.6f, 0.0f, 0.8f)));
        influences.first.push_back(0);
        for (std::size_t v = 0; v < kVertices; ++v) {
            positions.emplace_back(number(engine), number(engine), number(engine));
            normals.emplace_back(glm::normalize(positions.back()));
            vertexPositions.push_back(static_cast<std::uint32_t>(v));
            for (std::size_t i = 0; i < kInfluences; ++i)
                influences.influences.push_back({static_cast<std::uint32_t>(engine() % kJoints), 0.25f});
            influences.first.push_back(static_cast<std::uint32_t>(influences.influences.size()));
        }
    }
};

void perVertex(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kVertices));
}

void copy(benchmark::State& state) {
    constexpr std::size_t kBytes = 2 * sizeof(glm::vec3) + kInfluences * sizeof(Influence);
    const std::vector<char> from(kVertices * kBytes, 1);
    std::vector<char> to(from.size());
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), from.size());
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
    }
    perVertex(state);
}

void skin(benchmark::State& state, SkinningWay way) {
    const Mesh mesh;
    std::vector<glm::vec3> positions(kVertices), normals(kVertices);
    std::vector<NormalMatrix> normalMatrices;
    for (auto _ : state) {
        skinPositions(mesh.influences, mesh.palette, mesh.positions, positions, &normalMatrices, way);
        transformNormals(normalMatrices, mesh.vertexPositions, mesh.normals, normals, way);
        benchmark::DoNotOptimize(normals.data());
        benchmark::ClobberMemory();
    }
    perVertex(state);
}

}  // namespace

int main(int count, char** arguments) {
    benchmark::Initialize(&count, arguments);
    benchmark::RegisterBenchmark("skin/copy", copy);
    benchmark::RegisterBenchmark("skin/baseline", skin, SkinningWay::Baseline);
    if (hasSkinningWay(SkinningWay::Avx2)) benchmark::RegisterBenchmark("skin/avx2", skin, SkinningWay::Avx2);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
