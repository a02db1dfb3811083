// A soft gradient or one colour, and a grid on the ground (the plane y = 0): thin lines at every step,
// stronger ones at every tenth, which fade out towards the edge and where they would be too dense. Values
// that never change are constants here, because each number of a uniform costs software OpenGL a millisecond
// of compiling.
const vec3 TOP = vec3(0.60, 0.63, 0.67), BOTTOM = vec3(0.80, 0.80, 0.79), LINE = vec3(0.35, 0.35, 0.36);  // sRGB
const float LINE_STRENGTH = 0.55;

// Converts sRGB to what the target stores: linear light, or sRGB if the target does not convert.
#ifdef ENCODES_ITSELF
vec3 taken(vec3 color) { return color; }
#else
vec3 taken(vec3 color) { return pow((color + 0.055) / 1.055, vec3(2.4)); }  // no linear segment: no colour here is nearly black
#endif

#ifdef ONE_COLOR
uniform vec3 color;
vec3 behindAll() { return color; }
#else
uniform float pictureHeight;
vec3 behindAll() { return mix(taken(BOTTOM), taken(TOP), gl_FragCoord.y / pictureHeight); }
#endif

#ifdef GRID
in vec4 ground;       // xy / z: where this pixel's line of sight meets it, in grid steps; it does if z and w are positive
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
    return mix(behindAll(), taken(LINE), LINE_STRENGTH * grid());
#else
    return behindAll();
#endif
}
