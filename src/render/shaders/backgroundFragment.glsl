in float height;
uniform vec3 top;  // as the target takes it: linear light, or sRGB where it does not turn one into the other
uniform vec3 bottom;
out vec4 out_color;

void main() { out_color = vec4(mix(bottom, top, height), 1.0); }
