// The mean of a pixel's samples, laid over the backdrop. Samples are read and written as linear light; the
// textures convert from and to sRGB.
uniform sampler2DMS samples;
uniform ivec4 drawn;  // first and last column and row; nothing was drawn outside, so the nearest pixel inside stands for those outside
out vec4 out_color;

void main() {
    ivec2 pixel = clamp(ivec2(gl_FragCoord.xy), drawn.xy, drawn.zw);  // outside of `drawn` always the same ones, which are in the cache
    vec4 sum = vec4(0.0);
    for (int i = 0; i < SAMPLES; ++i) sum += texelFetch(samples, pixel, i);
    out_color = sum / float(SAMPLES);
#ifdef BACKDROP
    out_color = vec4(out_color.rgb + backdrop() * (1.0 - out_color.a), 1.0);
#endif
}
