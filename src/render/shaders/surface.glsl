// The first part of both fragment shaders: the fragment's material, its normal, and functions that output a colour.
// TEXTURED has a bit per slot: 1 if a material of the model has a picture there.
in vec3 modelPosition;
in vec3 modelNormal;
#ifdef VERTEX_COLORS
in vec4 vertexColor;
#endif
#ifdef BUMP
in vec4 modelTangent;
#endif
#ifdef SEPARATE_COORDS
in vec2 textureCoords[7];
#define COORDS(slot) textureCoords[slot]
#else
in vec2 textureCoords;
#define COORDS(slot) textureCoords
#endif

const int EMISSION = 0, AMBIENT = 1, DIFFUSE = 2, SPECULAR = 3, REFLECTIVE = 4, TRANSPARENT = 5, BUMPMAP = 6;

uniform vec4 slotColors[7];  // as in the file; with studio light, diffuse and emission are linear light
#if TEXTURED != 0
uniform sampler2D slotTextures[7];
#endif

uniform vec4 eye;  // the camera's position, w = 1, or the direction towards it, w = 0
#ifdef SEE_THROUGH
uniform int opaqueMode;  // -1: solid; else 0 to 3: A_ONE, RGB_ZERO, A_ZERO, RGB_ONE
uniform float transparency;
uniform ivec2 pass;      // x: 0 all, 1 only opaque, 2 only transparent fragments; y: 0 all, -1 back, 1 front faces
#endif

out vec4 out_color;

vec3 encoded(vec3 light) {
    vec3 c = clamp(light, 0.0, 1.0);
    return mix(c * 12.92, 1.055 * pow(max(c, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

vec3 decoded(vec3 c) {
    return mix(c / 12.92, pow((max(c, vec3(0.0)) + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}

// The texel of a slot's picture with the numbers of the file. OpenGL returns linear light, which is converted back.
#define PICTURE(slot) fileColor(texture(slotTextures[slot], COORDS(slot)))
vec4 fileColor(vec4 light) { return vec4(encoded(light.rgb), light.a); }

#ifdef SEE_THROUGH
vec4 transparentColor() {
#if (TEXTURED & 32) != 0
    return slotColors[TRANSPARENT] * PICTURE(TRANSPARENT);
#else
    return slotColors[TRANSPARENT];
#endif
}

// COLLADA 1.4.1, "Determining transparency (opacity)". opacity() in src/model/Material.cpp is the same.
float opacity() {
    if (opaqueMode < 0) return 1.0;
    vec4 color = transparentColor();
    float luminance = dot(color.rgb, vec3(0.212671, 0.715160, 0.072169));
    float amount = (opaqueMode == 0 || opaqueMode == 2 ? color.a : luminance) * transparency;
    return clamp(opaqueMode == 0 || opaqueMode == 3 ? amount : 1.0 - amount, 0.0, 1.0);
}
#else
float opacity() { return 1.0; }
#endif

vec3 towardsEye() { return normalize(eye.w > 0.5 ? eye.xyz - modelPosition : eye.xyz); }

// 1 if the triangle's normals point to the camera's side, -1 if the camera sees its back. It is computed from the
// triangle in model space, so it is right for mirrored models and for both orders of corners.
float seenSide(vec3 normal, vec3 view) {
    vec3 face = cross(dFdx(modelPosition), dFdy(modelPosition));
    float facing = dot(face, normal) * dot(face, view);
    return facing < 0.0 ? -1.0 : 1.0;
}

#ifdef BUMP
uniform sampler2D bumpTexture;
uniform bool bumped;
vec3 bumpedNormal(vec3 normal) {
    vec3 tangent = modelTangent.xyz - normal * dot(normal, modelTangent.xyz);
    if (!bumped || dot(tangent, tangent) < 1e-12) return normal;
    tangent = normalize(tangent);
    vec3 bitangent = cross(normal, tangent) * modelTangent.w;
    vec3 n = texture(bumpTexture, COORDS(BUMPMAP)).xyz * 2.0 - 1.0;
    return normalize(tangent * n.x + bitangent * n.y + normal * n.z);
}
#endif

// The unit normal on the camera's side. Lines have no normal, and are lit as if they faced the camera.
vec3 facingNormal(vec3 view, out float side) {
    side = 1.0;
    float size = length(modelNormal);
    if (size < 1e-6) return view;
    vec3 normal = modelNormal / size;
    side = seenSide(normal, view);
#ifdef BUMP
    normal = bumpedNormal(normal);
#endif
    return normal * side;
}

// Discards fragments that another pass draws.
void keepForPass(float alpha, float side) {
#ifdef SEE_THROUGH
    bool solid = alpha > 0.996;
    if (pass.x == 1 && !solid) discard;
    if (pass.x == 2 && (solid || alpha <= 0.0)) discard;
    if (pass.y != 0 && float(pass.y) != side) discard;
#endif
}

// Output a colour that is linear light (giveLight) or has the numbers of a file (giveEncoded). The output is
// premultiplied by alpha, and is linear light, or sRGB if the target does not convert.
#ifdef ENCODES_ITSELF
void giveLight(vec3 light, float alpha) { out_color = vec4(encoded(light) * alpha, alpha); }
void giveEncoded(vec3 color, float alpha) { out_color = vec4(clamp(color, 0.0, 1.0) * alpha, alpha); }
#else
void giveLight(vec3 light, float alpha) { out_color = vec4(clamp(light, 0.0, 1.0) * alpha, alpha); }
void giveEncoded(vec3 color, float alpha) { giveLight(decoded(color), alpha); }
#endif
