#include "render/ShaderProgram.h"

#include <cassert>
#include <cstddef>

#include "render/ShaderSource.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {
namespace {

using Shader = GlObject<gl::deleteShader>;

std::string text(std::initializer_list<std::string_view> names, const std::string& defines) {
    std::string source = "#version 330 core\n" + defines;
    for (const std::string_view name : names) {
        assert(!shaderSource(name).empty());
        source += shaderSource(name);
    }
    return source;
}

Shader compile(GLenum stage, std::initializer_list<std::string_view> names, const std::string& defines) {
    const std::string source = text(names, defines);
    const char* characters = source.c_str();
    Shader shader(glCreateShader(stage));
    glShaderSource(shader.id(), 1, &characters, nullptr);
    glCompileShader(shader.id());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader.id(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw GraphicsError("shader " + std::string(*names.begin()) + " does not compile: " + log);
}

void link(GLuint program) {
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) return;
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw GraphicsError("shader program does not link: " + log);
}

}  // namespace

ShaderProgram::ShaderProgram(const Stages& stages, const std::string& defines,
                             std::span<const char* const> captured)
    : program_(glCreateProgram()) {
    const Shader vertex = compile(GL_VERTEX_SHADER, stages.vertex, defines);
    glAttachShader(program_.id(), vertex.id());
    Shader fragment;
    if (stages.fragment.size() > 0) {
        fragment = compile(GL_FRAGMENT_SHADER, stages.fragment, defines);
        glAttachShader(program_.id(), fragment.id());
    }
    if (!captured.empty()) {
        glTransformFeedbackVaryings(program_.id(), static_cast<GLsizei>(captured.size()), captured.data(),
                                    GL_INTERLEAVED_ATTRIBS);
    }
    link(program_.id());
    glDetachShader(program_.id(), vertex.id());
    if (fragment.id()) glDetachShader(program_.id(), fragment.id());
}

void setUniform(GLint location, int value) {
    glUniform1i(location, value);
}

void setUniform(GLint location, float value) {
    glUniform1f(location, value);
}

void setUniform(GLint location, const glm::vec2& value) {
    glUniform2fv(location, 1, &value.x);
}

void setUniform(GLint location, const glm::vec3& value) {
    glUniform3fv(location, 1, &value.x);
}

void setUniform(GLint location, const glm::vec4& value) {
    glUniform4fv(location, 1, &value.x);
}

void setUniform(GLint location, const glm::ivec4& value) {
    glUniform4iv(location, 1, &value.x);
}

void setUniform(GLint location, const glm::mat3x4& value) {
    glUniformMatrix3x4fv(location, 1, GL_FALSE, &value[0][0]);
}

void setUniform(GLint location, const glm::mat4& value) {
    glUniformMatrix4fv(location, 1, GL_FALSE, &value[0][0]);
}

}  // namespace walkcycle
