#pragma once

#include <epoxy/gl.h>

#include "walkcycle/model/Material.h"

namespace walkcycle {

// The locations of the vertex shader's inputs, as in animatedModelVertex.glsl.
namespace VertexInput {
inline constexpr GLuint kPosition = 0;
inline constexpr GLuint kNormal = 1;
inline constexpr GLuint kJointIndices = 2;
inline constexpr GLuint kWeights = 3;
inline constexpr GLuint kMoreInfluences = 4;
inline constexpr GLuint kPositionIndex = 5;
inline constexpr GLuint kColor = 6;
inline constexpr GLuint kTangent = 7;
inline constexpr GLuint kTextureCoords = 8;  // the last; if slots use different sets, 8 + slot
}  // namespace VertexInput

// The texture units of the shader's samplers. The units below kSlotCount are for the pictures: unit s for slot s.
namespace TextureUnit {
inline constexpr int kPalette = kSlotCount;
inline constexpr int kMoreInfluences = kPalette + 1;
inline constexpr int kMorphs = kPalette + 2;
inline constexpr int kPositionDeltas = kPalette + 3;
inline constexpr int kNormalDeltas = kPalette + 4;
inline constexpr int kLights = kPalette + 5;
}  // namespace TextureUnit

}  // namespace walkcycle
