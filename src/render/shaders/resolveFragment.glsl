// The mean of a pixel's samples, over the backdrop where they leave it open. They are fetched as light and given as light,
// whatever the bytes between are.
uniform sampler2DMS samples;
uniform ivec4 drawn;  // first and last column and row; outside nothing was drawn, so that any pixel beside it will do
out vec4 out_color;

void main() {
    ivec2 pixel = clamp(ivec2(gl_FragCoord.xy), drawn.xy, drawn.zw);  // one that the processor's cache has
    vec4 sum = vec4(0.0);
    for (int i = 0; i < SAMPLES; ++i) sum += texelFetch(samples, pixel, i);
    out_color = sum / float(SAMPLES);
#ifdef BACKDROP
    out_color = vec4(out_color.rgb + backdrop() * (1.0 - out_color.a), 1.0);
#endif
}
