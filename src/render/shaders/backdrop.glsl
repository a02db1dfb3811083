// The background: a gradient or one colour, and a grid on the ground (the plane y = 0) with thin lines at every step
// and stronger lines at every tenth. Lines fade out with the distance from the grid's centre, and far away, before
// they lie too close together. Values that never change are constants: software OpenGL takes a millisecond longer to
// compile a shader for each number of a uniform.
const vec3 TOP = vec3(0.60, 0.63, 0.67), BOTTOM = vec3(0.80, 0.80, 0.79), LINE = vec3(0.35, 0.35, 0.36);  // sRGB
const float LINE_STRENGTH = 0.55;

// Converts sRGB to what the target stores: linear light, or sRGB if the target does not convert.
#ifdef ENCODES_ITSELF
vec3 stored(vec3 color) { return color; }
#else
// Without the linear part of sRGB, which is for nearly black colours only.
vec3 stored(vec3 color) { return pow((color + 0.055) / 1.055, vec3(2.4)); }
#endif

#ifdef ONE_COLOR
uniform vec3 color;
vec3 plainBackground() { return color; }
#else
uniform float pictureHeight;
vec3 plainBackground() { return mix(stored(BOTTOM), stored(TOP), gl_FragCoord.y / pictureHeight); }
#endif

#ifdef GRID
in vec4 ground;       // xy / z: the point of the ground at this pixel, in grid steps; visible if z and w are positive
uniform vec3 fading;  // xy: the grid's centre; z: the radius at which it has faded out

float lines(vec2 cells, vec2 width) {
    vec2 away = abs(fract(cells - 0.5) - 0.5) / max(width, vec2(1e-6));  // in pixels
    float crowded = clamp(1.0 - max(width.x, width.y) * 3.0, 0.0, 1.0);
    return clamp(1.2 - min(away.x, away.y), 0.0, 1.0) * crowded;
}

float grid() {
    vec2 cells = ground.xy / (ground.z > 1e-30 ? ground.z : 1e-30);
    vec2 width = fwidth(cells);
    float away = length(cells - fading.xy) / fading.z;
    if (!(min(ground.z, ground.w) > 0.0 && away < 1.0)) return 0.0;
    float strength = max(lines(cells, width) * 0.45, lines(cells / 10.0, width / 10.0));
    return strength * (1.0 - smoothstep(0.25, 1.0, away));
}
#endif

vec3 backdrop() {
#ifdef GRID
    return mix(plainBackground(), stored(LINE), LINE_STRENGTH * grid());
#else
    return plainBackground();
#endif
}
