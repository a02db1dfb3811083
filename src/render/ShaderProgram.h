#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include <glm/mat3x4.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/GlObject.h"

namespace walkcycle {

// A linked vertex and fragment shader. The source of a stage is `#version 330 core`, then the given #defines, then the
// text of one or more files of src/render/shaders, which are named without ".glsl".
class ShaderProgram {
public:
    struct Stages {
        std::initializer_list<std::string_view> vertex;
        std::initializer_list<std::string_view> fragment;  // empty: none, for transform feedback
    };

    // `captured` are outputs of the vertex shader that transform feedback writes, interleaved. Throws
    // GraphicsError with the compiler's message; the fault is ours or the driver's, never a file's.
    explicit ShaderProgram(const Stages& stages, const std::string& defines = {},
                           std::span<const char* const> captured = {});

    void start() const { glUseProgram(program_.id()); }

    // The location of a uniform; -1 if the shader does not use it. Setting location -1 has no effect.
    GLint uniform(const char* name) const { return glGetUniformLocation(program_.id(), name); }

    // Sets the texture unit of a sampler, once after linking. The program must be started.
    void setSampler(const char* name, int unit) const { glUniform1i(uniform(name), unit); }

private:
    GlObject<gl::deleteProgram> program_;
};

// Sets a uniform of the started program.
void setUniform(GLint location, int value);
void setUniform(GLint location, float value);
void setUniform(GLint location, const glm::vec2& value);
void setUniform(GLint location, const glm::vec3& value);
void setUniform(GLint location, const glm::vec4& value);
void setUniform(GLint location, const glm::ivec4& value);
void setUniform(GLint location, const glm::mat3x4& value);
void setUniform(GLint location, const glm::mat4& value);

}  // namespace walkcycle
