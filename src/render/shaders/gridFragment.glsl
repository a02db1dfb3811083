// Thin lines at every step, stronger ones at every tenth, fading towards the edge and where they would crowd.
in vec2 ground;
uniform vec3 center;
uniform float radius;
uniform float spacing;
uniform vec4 lineColor;  // linear light, alpha of the strongest line
uniform bool encodesItself;
out vec4 out_color;

float lines(vec2 cells) {
    vec2 width = fwidth(cells);
    vec2 away = abs(fract(cells - 0.5) - 0.5) / max(width, vec2(1e-6));  // in pixels
    float near = min(away.x, away.y);
    float crowded = clamp(1.0 - max(width.x, width.y) * 3.0, 0.0, 1.0);
    return clamp(1.2 - near, 0.0, 1.0) * crowded;
}

void main() {
    float fade = 1.0 - smoothstep(0.25, 1.0, length(ground - center.xz) / radius);
    float strength = max(lines(ground / spacing) * 0.45, lines(ground / (spacing * 10.0)));
    float alpha = lineColor.a * strength * fade;
    if (alpha <= 0.002) discard;
    vec3 color = encodesItself ? pow(lineColor.rgb, vec3(1.0 / 2.2)) : lineColor.rgb;
    out_color = vec4(color * alpha, alpha);
}
