// Drawing with software OpenGL or whatever EGL finds, without a display:
//   bench_draw [FILE.dae] [--benchmark_...]
// A frame and its pixels against a bare textured draw of the same triangles; many walkers one by one, and as a crowd.
// Times are of the whole process, since software OpenGL draws with several threads.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "walkcycle/crowd/CrowdPoser.h"
#include "walkcycle/loaders/ColladaLoader.h"
#include "walkcycle/loaders/LoadOptions.h"
#include "walkcycle/model/CpuSkinning.h"
#include "walkcycle/platform/HeadlessContext.h"
#include "walkcycle/render/AnimatedModelRenderer.h"
#include "walkcycle/render/CrowdRenderer.h"
#include "walkcycle/render/Framebuffer.h"

namespace {

using namespace walkcycle;

constexpr int kWidth = 640, kHeight = 480, kSamples = 4;

struct Stage {
    HeadlessContext context;
    std::shared_ptr<const Model> model;
    std::optional<AnimatedModel> walker;
    Bounds bounds;

    explicit Stage(const std::string& file) : model(std::make_shared<const Model>(loadCollada(file, {}))) {
        walker.emplace(model);
        if (!model->animations.empty()) walker->doAnimation(model->animations.front());
        bounds = walker->bounds();
    }
    double length() const { return walker->animator().animation()->lengthInSeconds(); }
};
Stage* stage = nullptr;

// What a bare program would do: the posed triangles in one buffer, the first picture of the model on them, no light.
class BareDraw {
public:
    BareDraw() {
        gatherTriangles();
        makeProgram();
        makeTexture();
        makeTargets();
    }

    void frame(const Camera& camera) {
        glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
        glViewport(0, 0, kWidth, kHeight);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_FRAMEBUFFER_SRGB);
        glDisable(GL_BLEND);
        glClearColor(0.5f, 0.5f, 0.5f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(program_);
        glUniformMatrix4fv(matrix_, 1, GL_FALSE, glm::value_ptr(camera.viewProjection()));
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glBindVertexArray(vertexArray_);
        glDrawArrays(GL_TRIANGLES, 0, count_);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
        glBlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
        glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels_.data());
    }

private:
    void gatherTriangles() {
        std::vector<float> numbers;
        std::vector<glm::vec3> positions, normals;
        CpuSkinning skinning;
        for (const MeshInstance& instance : stage->model->instances) {
            const MeshData& mesh = stage->model->meshes[static_cast<std::size_t>(instance.mesh)];
            skinning.vertices(*stage->model, instance, stage->walker->animator().modelTransforms(),
                              stage->walker->animator().parameters(), positions, normals);
            for (const std::uint32_t vertex : mesh.indices) {
                const glm::vec3 p = positions[vertex];
                const glm::vec2 t = mesh.texCoordSets.empty() || mesh.texCoordSets[0].coords.empty()
                                        ? glm::vec2(0.0f)
                                        : mesh.texCoordSets[0].coords[vertex];
                numbers.insert(numbers.end(), {p.x, p.y, p.z, t.x, 1.0f - t.y});
            }
        }
        count_ = static_cast<GLsizei>(numbers.size() / 5);
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers.size() * sizeof(float)), numbers.data(),
                     GL_STATIC_DRAW);
        glGenVertexArrays(1, &vertexArray_);
        glBindVertexArray(vertexArray_);
        glEnableVertexAttribArray(0);
        glEnableVertexAttribArray(1);
        glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 20, nullptr);
        glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, 20,
                              reinterpret_cast<const void*>(std::uintptr_t{12}));
    }

    void makeProgram() {
        const char* vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 coords;
uniform mat4 matrix;
out vec2 at;
void main() { at = coords; gl_Position = matrix * vec4(position, 1.0); })";
        const char* fragment = R"(#version 330 core
in vec2 at;
uniform sampler2D picture;
out vec4 color;
void main() { color = texture(picture, at); })";
        program_ = glCreateProgram();
        for (const auto& [kind, text] :
             {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
            const GLuint shader = glCreateShader(static_cast<GLenum>(kind));
            glShaderSource(shader, 1, &text, nullptr);
            glCompileShader(shader);
            glAttachShader(program_, shader);
        }
        glLinkProgram(program_);
        matrix_ = glGetUniformLocation(program_, "matrix");
    }

    void makeTexture() {
        glGenTextures(1, &texture_);
        glBindTexture(GL_TEXTURE_2D, texture_);
        const std::uint8_t white[] = {255, 255, 255, 255};
        const Image* image = nullptr;
        for (const Texture& texture : stage->model->textures)
            if (!image) image = texture.image.get();
        if (image)
            glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image->width, image->height, 0, GL_RGBA,
                         GL_UNSIGNED_BYTE, image->rgba.data());
        else
            glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white);
        glGenerateMipmap(GL_TEXTURE_2D);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    }

    GLuint newTarget(GLsizei samples, bool depth) {
        GLuint framebuffer = 0;
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        const auto attach = [&](GLenum place, GLenum format) {
            GLuint buffer = 0;
            glGenRenderbuffers(1, &buffer);
            glBindRenderbuffer(GL_RENDERBUFFER, buffer);
            glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, kWidth, kHeight);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
        };
        attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8);
        if (depth) attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24);
        return framebuffer;
    }

    void makeTargets() {
        drawn_ = newTarget(kSamples, true);
        resolved_ = newTarget(0, false);
    }

    GLuint vertexArray_ = 0, program_ = 0, texture_ = 0, drawn_ = 0, resolved_ = 0;
    GLint matrix_ = -1;
    GLsizei count_ = 0;
    std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(std::size_t{4} * kWidth * kHeight);
};

// The first picture makes shaders and buffers; those that follow are measured.
template <typename Draw>
void repeat(benchmark::State& state, Draw draw) {
    draw();
    glFinish();
    for (auto _ : state) draw();
}

Camera framed(const Bounds& bounds) {
    return Camera::framing(bounds, static_cast<float>(kWidth) / kHeight);
}

void bareFrame(benchmark::State& state) {
    BareDraw bare;
    const Camera camera = framed(stage->bounds);
    repeat(state, [&] { bare.frame(camera); });
}

void frame(benchmark::State& state, const RenderOptions& options) {
    AnimatedModelRenderer renderer;
    Framebuffer picture(kWidth, kHeight, kSamples);
    const Camera camera = framed(stage->bounds);
    repeat(state, [&] {
        renderer.render(*stage->walker, camera, picture, options);
        benchmark::DoNotOptimize(picture.read().rgba.data());
    });
}

// A square full of walkers, each at a time of its own.
struct Crowd {
    std::size_t count;
    Bounds bounds;

    explicit Crowd(std::size_t walkers) : count(walkers) {
        for (const std::size_t corner : {std::size_t{0}, count - 1}) {
            const glm::vec3 shift(placement(corner)[3]);
            bounds.add(stage->bounds.min + shift);
            bounds.add(stage->bounds.max + shift);
        }
    }
    glm::mat4 placement(std::size_t walker) const {
        const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
        const float step = stage->bounds.diagonal() * 0.7f;
        return glm::translate(glm::mat4(1.0f), glm::vec3(static_cast<float>(walker % side) * step, 0.0f,
                                                         static_cast<float>(walker / side) * step));
    }
    double seconds(std::size_t walker) const {
        return stage->length() * static_cast<double>(walker) / static_cast<double>(count);
    }
    std::vector<JointRows> palettes() const {
        std::vector<JointRows> all;
        const std::size_t joints = jointsPerWalker(*stage->model);
        for (std::size_t i = 0; i < count; ++i) {
            stage->walker->setTime(seconds(i));
            appendPalette(*stage->walker, all);
            place(std::span(all).last(joints), placement(i));
        }
        stage->walker->setTime(0.0);
        return all;
    }
};

// The poses are made before: only the drawing is measured.
void oneByOne(benchmark::State& state) {
    const Crowd crowd(static_cast<std::size_t>(state.range(0)));
    const Camera camera = framed(crowd.bounds);
    std::vector<AnimatedModel> walkers;
    for (std::size_t i = 0; i < crowd.count; ++i) {
        walkers.push_back(*stage->walker);
        walkers.back().setTime(crowd.seconds(i));
    }
    AnimatedModelRenderer renderer;
    Framebuffer picture(kWidth, kHeight, kSamples);
    repeat(state, [&] {
        renderer.clear(picture);
        for (std::size_t i = 0; i < crowd.count; ++i) {
            Camera moved = camera;
            moved.view = camera.view * crowd.placement(i);
            renderer.draw(walkers[i], moved, picture);
        }
        glFinish();
    });
}

void asACrowd(benchmark::State& state) {
    const Crowd crowd(static_cast<std::size_t>(state.range(0)));
    const Camera camera = framed(crowd.bounds);
    const std::vector<JointRows> palettes = crowd.palettes();
    AnimatedModelRenderer renderer;
    CrowdRenderer instanced;
    Framebuffer picture(kWidth, kHeight, kSamples);
    repeat(state, [&] {
        renderer.clear(picture);
        instanced.draw(*stage->walker, palettes, camera, picture);
        glFinish();
    });
}

// Everything: poses at new times, places, upload, drawing and the pixels.
void crowdPicture(benchmark::State& state) {
    const Crowd crowd(static_cast<std::size_t>(state.range(0)));
    if (stage->model->instances.size() != 1 || stage->model->skins.empty()) {
        state.SkipWithError("the poser wants a model of one skinned mesh");
        return;
    }
    const Camera camera = framed(crowd.bounds);
    CrowdPoser poser(stage->model->skeleton, stage->model->animations.front(), stage->model->skins.front());
    std::vector<JointRows> palettes(crowd.count * poser.paletteSize());
    std::vector<double> seconds(crowd.count);
    AnimatedModelRenderer renderer;
    CrowdRenderer instanced;
    Framebuffer picture(kWidth, kHeight, kSamples);
    double now = 0.0;
    repeat(state, [&] {
        now += 1.0 / 60.0;
        for (std::size_t i = 0; i < crowd.count; ++i) seconds[i] = now + crowd.seconds(i);
        poser.pose(seconds, palettes);
        for (std::size_t i = 0; i < crowd.count; ++i)
            place(std::span(palettes).subspan(i * poser.paletteSize(), poser.paletteSize()),
                  crowd.placement(i));
        renderer.clear(picture);
        instanced.draw(*stage->walker, palettes, camera, picture);
        benchmark::DoNotOptimize(picture.read().rgba.data());
    });
    state.counters["frames/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

}  // namespace

int main(int count, char** words) {
    benchmark::Initialize(&count, words);
    Stage here(count > 1 ? words[1] : WALKCYCLE_SOURCE_DIR "/res/walker.dae");
    stage = &here;
    benchmark::AddCustomContext("device", here.context.description());
    const auto add = [](const char* name, auto run) {
        return benchmark::RegisterBenchmark(name, run)
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime();
    };
    add("frame/bare", bareFrame);
    add("frame/studio", [](benchmark::State& state) { frame(state, {}); });
    add("frame/plain", [](benchmark::State& state) {
        frame(state, {.background = Background::Color, .backgroundColor = glm::vec3(0.5f), .grid = false});
    });
    add("walkers/oneByOne", oneByOne)->Arg(100);
    add("walkers/crowd", asACrowd)->Arg(100)->Arg(1'000);
    // The calling thread alone: what is left to the processor where a GPU draws.
    for (const auto& [name, run] : {std::pair{"calls/oneByOne", &oneByOne}, {"calls/crowd", &asACrowd}})
        benchmark::RegisterBenchmark(name, run)->Unit(benchmark::kMillisecond)->Arg(100);
    add("walkers/picture", crowdPicture)->Arg(1'000)->UseRealTime();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
