// The ground: a square in the plane y = 0 around what is shown.
uniform mat4 viewProjection;
uniform vec3 center;
uniform float radius;
out vec2 ground;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    ground = center.xz + corner * radius;
    gl_Position = viewProjection * vec4(ground.x, 0.0, ground.y, 1.0);
}
