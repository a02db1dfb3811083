// A soft gradient, and on the ground, the plane y = 0, a grid: thin lines at every step, stronger ones at every tenth,
// fading towards the edge and where they would crowd.
in float height;
uniform vec3 top;  // as the target takes it: linear light, or sRGB where it does not turn one into the other
uniform vec3 bottom;

#ifdef GRID
in vec3 nearest;  // where this pixel's line of sight begins and ends, in model space
in vec3 farthest;
uniform vec3 center;
uniform float radius;
uniform float spacing;
uniform vec4 lineColor;  // alpha: how strong the strongest line is

float lines(vec2 cells, vec2 width) {
    vec2 away = abs(fract(cells - 0.5) - 0.5) / max(width, vec2(1e-6));  // in pixels
    float crowded = clamp(1.0 - max(width.x, width.y) * 3.0, 0.0, 1.0);
    return clamp(1.2 - min(away.x, away.y), 0.0, 1.0) * crowded;
}

float grid() {
    vec3 sight = farthest - nearest;
    float along = -nearest.y / (abs(sight.y) > 1e-30 ? sight.y : 1e-30);
    vec2 ground = nearest.xz + sight.xz * along;
    vec2 width = fwidth(ground) / spacing;
    float away = length(ground - center.xz) / radius;
    if (!(along > 0.0 && away < 1.0)) return 0.0;
    float strength = max(lines(ground / spacing, width) * 0.45, lines(ground / (spacing * 10.0), width / 10.0));
    return strength * (1.0 - smoothstep(0.25, 1.0, away));
}
#endif

vec3 backdrop() {
    vec3 color = mix(bottom, top, height);
#ifdef GRID
    color = mix(color, lineColor.rgb, lineColor.a * grid());
#endif
    return color;
}
