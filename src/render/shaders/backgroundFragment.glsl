// The backdrop by itself, in one pass over the picture before anything else is drawn.
out vec4 out_color;

void main() { out_color = vec4(backdrop(), 1.0); }
