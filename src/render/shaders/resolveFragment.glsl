// The mean of a pixel's samples, in front of the backdrop. The shader computes in linear light; OpenGL converts the
// samples from sRGB and the result to sRGB.
uniform sampler2DMS samples;
uniform ivec4 drawn;  // first column and row, last column and row: outside, all samples are empty
out vec4 out_color;

void main() {
    // For a pixel outside of `drawn`, the nearest pixel inside is read: it is empty, too, and in the cache.
    ivec2 pixel = clamp(ivec2(gl_FragCoord.xy), drawn.xy, drawn.zw);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < SAMPLES; ++i) sum += texelFetch(samples, pixel, i);
    out_color = sum / float(SAMPLES);
#ifdef BACKDROP
    out_color = vec4(out_color.rgb + backdrop() * (1.0 - out_color.a), 1.0);
#endif
}
