// Positions in model space, for the skeleton.
layout(location = 0) in vec3 in_position;
uniform mat4 viewProjection;

void main() { gl_Position = viewProjection * vec4(in_position, 1.0); }
