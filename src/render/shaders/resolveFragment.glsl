// The mean of a pixel's samples. They are fetched as light and given as light, whatever the bytes between are.
uniform sampler2DMS samples;
uniform int sampleCount;
in float height;
out vec4 out_color;

void main() {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < sampleCount; ++i) sum += texelFetch(samples, ivec2(gl_FragCoord.xy), i);
    out_color = sum / float(sampleCount);
}
