// One colour, for the edges of wireframes and the joints of skeletons. flatColor is linear light, premultiplied.
uniform vec4 flatColor;
uniform bool encodesItself;
out vec4 out_color;

void main() {
    vec3 c = flatColor.rgb;
    out_color = encodesItself ? vec4(pow(c, vec3(1.0 / 2.2)), flatColor.a) : flatColor;
}
