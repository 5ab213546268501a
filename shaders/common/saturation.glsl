// A sample of the saturation stage as a word: in the upper half the depth behind which nothing
// shows, in steps of the 16-bit depth test, so that the largest of some words is the furthest; in
// the lower half the colour of the splat that lies there, 5, 6 and 5 bits. Depth is 1 less the
// share of the key that splats are sorted by, as the quads have it.

// At the furthest depth, which hides nothing.
const uint NEVER_SATURATED = 0xffff0000u;
// The largest numbers of red, green and blue.
const uvec3 COLOR_MAX = uvec3(31u, 63u, 31u);

// A step further than the depth says, so that rounding culls nothing.
uint saturated_word(float depth, vec3 color) {
    uvec3 rgb = uvec3(round(color * vec3(COLOR_MAX)));
    return min(uint(depth * 65535.0 + 1.5), 65535u) << 16u | rgb.r << 11u | rgb.g << 5u | rgb.b;
}

float saturated_depth(uint word) { return float(word >> 16u) / 65535.0; }

vec3 saturated_color(uint word) {
    return vec3(uvec3(word >> 11u, word >> 5u, word) & COLOR_MAX) / vec3(COLOR_MAX);
}
