// A mesh for a renderer of your own: vertices with at most four influences, ready for a vertex buffer, and the error that
// the limit makes while the model moves. Without OpenGL.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <walkcycle/animation/Animator.h>
#include <walkcycle/loaders/ColladaLoader.h>
#include <walkcycle/model/Influences.h>

using namespace walkcycle;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

struct Vertex {
    glm::vec3 position, normal;
    std::uint32_t joints[4];  // indices into the palette, which computePalette() fills for a pose
    float weights[4];
};

std::vector<Vertex> vertexBuffer(const MeshData& mesh, const LimitedInfluences& influences) {
    std::vector<Vertex> vertices(mesh.vertexCount());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        vertices[v].position = mesh.positions[mesh.vertexPositions[v]];
        vertices[v].normal = mesh.normals[v];
        std::copy_n(&influences.joints[4 * v], 4, vertices[v].joints);
        std::copy_n(&influences.weights[4 * v], 4, vertices[v].weights);
    }
    return vertices;
}

// The largest error at sixteen moments of the clip.
float errorWhilePlaying(const Model& model, const MeshInstance& instance, const LimitedInfluences& limited) {
    const Deformer& deformer = instance.deformers.front();
    Animator animator(model.skeleton, model.restParameters());
    if (!model.animations.empty()) animator.doAnimation(model.animations.front());
    const double length = model.animations.empty() ? 0.0 : model.animations.front().lengthInSeconds();
    std::vector<glm::mat4> palette;
    float error = 0.0f;
    for (int i = 0; i < 16; ++i) {
        animator.setTime(length * i / 16);
        computePalette(model.skins[at(deformer.index)], animator.modelTransforms(), palette);
        error = std::max(error, limitingError(limited, model.influences[at(deformer.influences)],
                                              model.meshes[at(instance.mesh)], palette));
    }
    return error;
}

void print(const Vertex& vertex) {
    for (int i = 0; i < 3; ++i) std::printf("%8.3f", static_cast<double>(vertex.position[i]));
    for (int i = 0; i < 4; ++i)
        std::printf("  %u %.3f", vertex.joints[i], static_cast<double>(vertex.weights[i]));
    std::printf("\n");
}

int main(int argc, char** argv) try {
    const Model model = loadCollada(argc > 1 ? argv[1] : "res/walker.dae");
    for (const MeshInstance& instance : model.instances) {
        if (instance.deformers.empty() || instance.deformers.front().kind != Deformer::Kind::Skin) continue;
        const MeshData& mesh = model.meshes[at(instance.mesh)];
        const LimitedInfluences limited =
            limitInfluences(model.influences[at(instance.deformers.front().influences)], mesh, 4);
        const std::vector<Vertex> vertices = vertexBuffer(mesh, limited);
        std::printf("%s: %zu vertices, %zu indices, %zu vertices cut to four influences (%.4f m)\n",
                    mesh.id.c_str(), vertices.size(), mesh.indices.size(), limited.cutVertices,
                    static_cast<double>(errorWhilePlaying(model, instance, limited)));
        for (std::size_t v = 0; v < std::min<std::size_t>(3, vertices.size()); ++v) print(vertices[v]);
    }
} catch (const LoadError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
