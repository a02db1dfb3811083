// Draws the backdrop directly, before the model. (resolveFragment.glsl draws it behind a finished picture instead.)
out vec4 out_color;

void main() { out_color = vec4(backdrop(), 1.0); }
