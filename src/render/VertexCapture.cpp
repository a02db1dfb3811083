#include "render/VertexCapture.h"

#include <cstddef>
#include <span>

namespace walkcycle {
namespace {

constexpr const char* kOutputs[] = {"modelPosition", "modelNormal"};

struct Captured {
    glm::vec3 position, normal;
};

}  // namespace

VertexCapture::Vertices VertexCapture::capture(const AnimatedModel& model, std::size_t instance) {
    const ModelResource::Instance& resource = model.resource()->instances()[instance];
    const MeshInstance& data = model.model().instances[instance];
    const std::size_t count = model.model().meshes[static_cast<std::size_t>(data.mesh)].vertexCount();
    if (resource.parts.empty() || count == 0) return {};

    states_.prepare(model);
    const ShaderProgram program({{"animatedModelVertex"}, {}}, deformDefines(model.resource()->needs()),
                                kOutputs);
    program.start();
    const DeformUniforms deform(program);
    deform.load(states_.bind(model, instance));
    model.resource()->vao(resource.parts.front().vao).bind();
    std::vector<Captured> captured(count);
    Vbo feedback(GL_TRANSFORM_FEEDBACK_BUFFER);
    feedback.store(std::span<const Captured>(captured), GL_STREAM_READ);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, feedback.id());
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(count * sizeof(Captured)),
                       captured.data());
    Vertices vertices;
    for (const Captured& vertex : captured) {
        vertices.positions.push_back(vertex.position);
        vertices.normals.push_back(vertex.normal);
    }
    return vertices;
}

}  // namespace walkcycle
