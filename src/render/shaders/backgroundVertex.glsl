// One triangle that is larger than the picture and covers it. There are no vertex inputs.
#ifdef GRID
uniform mat3x4 groundAt;  // Backdrop::Grid::groundAt
out vec4 ground;
#endif

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
#ifdef GRID
    ground = groundAt * vec3(corner, 1.0);
#endif
    gl_Position = vec4(corner, 0.0, 1.0);
}
