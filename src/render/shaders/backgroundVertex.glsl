// One triangle that covers the picture.
out float height;  // 0 at the bottom, 1 at the top
#ifdef GRID
uniform mat4 fromPicture;  // the inverse of viewProjection
out vec3 nearest;
out vec3 farthest;

vec3 place(vec2 corner, float depth) {
    vec4 point = fromPicture * vec4(corner, depth, 1.0);
    return point.xyz / point.w;
}
#endif

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    height = corner.y * 0.5 + 0.5;
#ifdef GRID
    nearest = place(corner, -1.0);
    farthest = place(corner, 1.0);
#endif
    gl_Position = vec4(corner, 0.0, 1.0);
}
