// The light of a photographer's studio, the same for every model: a warm key light from the upper left of the camera, a
// cool fill light from the right, a rim light from behind, light from the sky and light that the ground reflects. Their
// sum is chosen so that a white surface that faces the key light is just white, not brighter.
uniform vec3 keyDirection;   // towards each light, in model space
uniform vec3 fillDirection;
uniform vec3 rimDirection;

const vec3 KEY = vec3(0.72, 0.69, 0.65);
const vec3 FILL = vec3(0.11, 0.125, 0.145);
const vec3 RIM = vec3(0.18, 0.19, 0.20);
const vec3 SKY = vec3(0.20, 0.21, 0.23);
const vec3 GROUND = vec3(0.11, 0.10, 0.09);

// The light of a large lamp, which reaches a little beyond the edge between the lit and the dark side.
float soft(vec3 normal, vec3 light) { return max((dot(normal, light) + 0.25) / 1.25, 0.0); }

vec3 baseColor() {
    vec3 color = slotColors[DIFFUSE].rgb;
#ifdef VERTEX_COLORS
    color *= decoded(vertexColor.rgb);
#endif
#if (TEXTURED & 4) != 0
    color *= texture(slotTextures[DIFFUSE], COORDS(DIFFUSE)).rgb;
#endif
    return color;
}

vec3 emission() {
    vec3 color = slotColors[EMISSION].rgb;
#if (TEXTURED & 1) != 0
    color *= texture(slotTextures[EMISSION], COORDS(EMISSION)).rgb;
#endif
    return color;
}

void main() {
    vec3 view = towardsEye();
    float side;
    vec3 normal = facingNormal(view, side);
    float alpha = opacity();
    keepForPass(alpha, side);

    vec3 light = KEY * soft(normal, keyDirection) + FILL * soft(normal, fillDirection) +
                 RIM * max(dot(normal, rimDirection), 0.0) + mix(GROUND, SKY, normal.y * 0.5 + 0.5);
    // A faint sheen, stronger at grazing angles, makes round shapes look round.
    vec3 halfway = normalize(keyDirection + view);
    float grazing = pow(1.0 - max(dot(normal, view), 0.0), 4.0);
    float alignment = max(dot(normal, halfway), 0.0);
    float cube = alignment * alignment * alignment;
    float sixth = cube * cube, twelfth = sixth * sixth;
    float sheen = 0.05 * twelfth * twelfth + 0.04 * grazing;
    giveLight(baseColor() * light + vec3(sheen) + emission(), alpha);
}
