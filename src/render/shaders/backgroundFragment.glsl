in float height;
uniform vec3 top;  // sRGB
uniform vec3 bottom;
uniform bool encodesItself;
out vec4 out_color;

vec3 decoded(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}

void main() {
    // Half a step of noise, the same in every picture, hides the bands of a slow gradient.
    float noise = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715)))) - 0.5;
    vec3 color = mix(bottom, top, smoothstep(0.0, 1.0, height)) + noise / 255.0;
    out_color = vec4(encodesItself ? color : decoded(color), 1.0);
}
