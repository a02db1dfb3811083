// The mean of a pixel's samples, over the backdrop where they leave it open. They are fetched as light and given as light,
// whatever the bytes between are.
uniform sampler2DMS samples;
out vec4 out_color;

void main() {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < SAMPLES; ++i) sum += texelFetch(samples, ivec2(gl_FragCoord.xy), i);
    out_color = sum / float(SAMPLES);
#ifdef BACKDROP
    out_color = vec4(out_color.rgb + backdrop() * (1.0 - out_color.a), 1.0);
#endif
}
