// The document's own materials and lights, by the formulas of COLLADA 1.4.1, chapter 8 ("<constant>",
// "<lambert>", "<phong>", "<blinn>"). The terms are added as numbers of the file, not as linear light: programs of the
// format's time did so, and a colour of the file is the same colour on the screen.
uniform int shadingModel;  // 0 constant, 1 lambert, 2 phong, 3 blinn
uniform float shininess;
uniform float reflectivity;
uniform vec3 ambientLight;
uniform int lightCount;
uniform samplerBuffer lights;  // four texels per light, which FileLights.h describes

vec3 slotValue(int slot) { return slotColors[slot].rgb; }

vec3 emission() {
#if (TEXTURED & 1) != 0
    return slotValue(EMISSION) * PICTURE(EMISSION).rgb;
#else
    return slotValue(EMISSION);
#endif
}

vec3 ambient() {
#if (TEXTURED & 2) != 0
    return slotValue(AMBIENT) * PICTURE(AMBIENT).rgb;
#else
    return slotValue(AMBIENT);
#endif
}

vec3 diffuse() {
    vec3 color = slotValue(DIFFUSE);
#ifdef VERTEX_COLORS
    color *= vertexColor.rgb;
#endif
#if (TEXTURED & 4) != 0
    color *= PICTURE(DIFFUSE).rgb;
#endif
    return color;
}

vec3 specular() {
#if (TEXTURED & 8) != 0
    return slotValue(SPECULAR) * PICTURE(SPECULAR).rgb;
#else
    return slotValue(SPECULAR);
#endif
}

vec3 reflective() {
#if (TEXTURED & 16) != 0
    return slotValue(REFLECTIVE) * PICTURE(REFLECTIVE).rgb;
#else
    return slotValue(REFLECTIVE);
#endif
}

float highlight(vec3 normal, vec3 towardsLight, vec3 view) {
    if (shadingModel < 2) return 0.0;
    float alignment = shadingModel == 2 ? dot(reflect(-towardsLight, normal), view)
                                        : dot(normal, normalize(towardsLight + view));
    return alignment > 0.0 ? pow(alignment, max(shininess, 1e-3)) : 0.0;
}

void main() {
    vec3 view = towardsEye();
    float side;
    vec3 normal = facingNormal(view, side);
    float alpha = opacity();
    keepForPass(alpha, side);

    vec3 color = emission() + ambient() * ambientLight + reflective() * reflectivity;
    vec3 surface = shadingModel > 0 ? diffuse() : vec3(0.0);
    vec3 shine = shadingModel > 1 ? specular() : vec3(0.0);
    for (int i = 0; i < lightCount; ++i) {
        vec4 position = texelFetch(lights, 4 * i);      // w = 1: position; w = 0: direction towards the light
        vec4 axis = texelFetch(lights, 4 * i + 1);      // direction, cosine of half the cone's angle (-2: no spot)
        vec4 intensity = texelFetch(lights, 4 * i + 2); // colour, falloff exponent
        vec4 fading = texelFetch(lights, 4 * i + 3);    // constant, linear and quadratic attenuation
        vec3 towardsLight = position.xyz - modelPosition * position.w;
        float distance = length(towardsLight);
        towardsLight = distance > 0.0 ? towardsLight / distance : normal;
        float amount = 1.0;
        if (position.w > 0.5) {
            float divisor = fading.x + distance * (fading.y + distance * fading.z);
            amount = divisor > 0.0 ? 1.0 / divisor : 1.0;
            float along = dot(-towardsLight, axis.xyz);
            if (axis.w > -1.5) amount *= along < axis.w ? 0.0 : pow(max(along, 1e-6), intensity.w);
        }
        float facing = max(dot(normal, towardsLight), 0.0);
        if (facing > 0.0) {
            color += intensity.rgb * amount * (surface * facing + shine * highlight(normal, towardsLight, view));
        }
    }
    giveEncoded(min(color, vec3(1.0)), alpha);
}
