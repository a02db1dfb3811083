// Deforms a vertex: morphs first, then the sum of all influences, as in the second episode of the series, for any
// number of joints and influences:
//     position = sum of weight[i] * palette[joint[i]] * position
// A mesh without a skin has a palette of one matrix. VertexInput.h has the same locations.
layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in uvec4 in_jointIndices;     // the first four influences
layout(location = 3) in vec4 in_weights;
#ifdef MORE_INFLUENCES
layout(location = 4) in uvec2 in_moreInfluences;   // [first, end) in moreInfluences
#endif
#ifdef MORPHS
layout(location = 5) in uint in_positionIndex;     // this vertex's position, as an index into the file's positions
#endif
#ifdef VERTEX_COLORS
layout(location = 6) in vec4 in_color;
#endif
#ifdef BUMP
layout(location = 7) in vec4 in_tangent;
#endif
#ifdef SEPARATE_COORDS
layout(location = 8) in vec2 in_textureCoords[7];  // one per slot of the material
#else
layout(location = 8) in vec2 in_textureCoords;
#endif

uniform samplerBuffer palette;         // three rows per joint
uniform usamplerBuffer moreInfluences;  // joint, and the weight as the bits of a float
uniform samplerBuffer morphs;          // the targets that are not at rest: number of the target, coefficient
uniform samplerBuffer positionDeltas;  // target after target, one delta per position
uniform samplerBuffer normalDeltas;    // target after target, one delta per vertex

uniform int firstJoint;      // index of this instance's first matrix in palette
uniform int jointsPerWalker; // in a crowd: matrices from one walker's palette to the next; else 0
uniform int influenceCount;  // the most influences of a vertex, up to four
uniform ivec2 morphRange;    // [first, end) in morphs
uniform int positionCount;   // of the mesh, for positionDeltas
uniform int vertexCount;     // of the mesh, for normalDeltas
uniform mat4 viewProjection;

out vec3 modelPosition;
out vec3 modelNormal;
#ifdef VERTEX_COLORS
out vec4 vertexColor;
#endif
#ifdef BUMP
out vec4 modelTangent;
#endif
#ifdef SEPARATE_COORDS
out vec2 textureCoords[7];
#else
out vec2 textureCoords;
#endif

// The three rows of the matrix are the columns of a mat3x4 here, so `vector * rows` is `matrix * vector` of the
// formula.
mat3x4 jointTransform(uint joint) {
    int texel = (firstJoint + gl_InstanceID * jointsPerWalker + int(joint)) * 3;
    return mat3x4(texelFetch(palette, texel), texelFetch(palette, texel + 1), texelFetch(palette, texel + 2));
}

mat3x4 sumOfInfluences() {
    mat3x4 sum = mat3x4(0.0);
    for (int i = 0; i < influenceCount; ++i) sum += jointTransform(in_jointIndices[i]) * in_weights[i];
#ifdef MORE_INFLUENCES
    for (uint i = in_moreInfluences.x; i < in_moreInfluences.y; ++i) {
        uvec2 influence = texelFetch(moreInfluences, int(i)).xy;
        sum += jointTransform(influence.x) * uintBitsToFloat(influence.y);
    }
#endif
    return sum;
}

// Normals are transformed by the inverse transpose, up to a factor: the matrix of cofactors, times the sign of the
// determinant. The cofactors exist even if there is no inverse.
vec3 transformNormal(mat3x4 rows, vec3 normal) {
    mat3 cofactors = mat3(cross(rows[1].xyz, rows[2].xyz), cross(rows[2].xyz, rows[0].xyz),
                          cross(rows[0].xyz, rows[1].xyz));
    float mirrored = dot(rows[0].xyz, cofactors[0]) < 0.0 ? -1.0 : 1.0;
    vec3 result = mirrored * (normal * cofactors);
    float size = length(result);
    return size > 0.0 ? result / size : vec3(0.0);
}

void main() {
    vec3 position = in_position;
    vec3 normal = in_normal;
#ifdef MORPHS
    for (int i = morphRange.x; i < morphRange.y; ++i) {
        vec2 morph = texelFetch(morphs, i).xy;
        position += morph.y * texelFetch(positionDeltas, int(morph.x) * positionCount + int(in_positionIndex)).xyz;
        normal += morph.y * texelFetch(normalDeltas, int(morph.x) * vertexCount + gl_VertexID).xyz;
    }
#endif
    mat3x4 transform = sumOfInfluences();
    modelPosition = vec4(position, 1.0) * transform;
    modelNormal = transformNormal(transform, normal);
#ifdef VERTEX_COLORS
    vertexColor = in_color;
#endif
#ifdef BUMP
    modelTangent = vec4(vec4(in_tangent.xyz, 0.0) * transform, in_tangent.w);
#endif
#ifdef SEPARATE_COORDS
    for (int i = 0; i < 7; ++i) textureCoords[i] = vec2(in_textureCoords[i].x, 1.0 - in_textureCoords[i].y);
#else
    textureCoords = vec2(in_textureCoords.x, 1.0 - in_textureCoords.y);
#endif
    gl_Position = viewProjection * vec4(modelPosition, 1.0);
}
