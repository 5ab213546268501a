// A Gaussian's 32 bytes in the model buffer, as `project` and `sh` read them; written by
// layout::pack. Pairs of words, in planes, GAUSSIAN_PAIRS pairs a Gaussian:
//
//   two a Gaussian           x y | z, log scales 0..16 | four joints | three weights, log scales
//                            16..24
//   one a Gaussian           nodes a b, first share from bit 5 on | node c, first share 0..5,
//                            second share, log scales 24..30; nodes have node_bits(), shares the
//                            rest
//   one a Gaussian           quaternion | RGB, opacity
//   four for 32 Gaussians    masks of those that have a basis row of rotation | scale | colour,
//                            number of earlier rows of rotation | scale | colour, first and last
//                            part, unused
//   half a Gaussian          from where it is drawn (project/facing.glsl), a word each; where an
//                            avatar says that
//   one a Gaussian           RGB as the camera sees it, three f16; with spherical harmonics only
//
// The first three pairs give a Gaussian's position and size: but for where it faces, nothing else
// is read of a culled one.

// Mean in canonical space, metres.
vec3 gaussian_position(uvec2 words) {
    vec3 coordinates = vec3(words.x & 0xffffu, words.x >> 16u, words.y & 0xffffu);
    return frame.position_min.xyz + frame.position_step.xyz * coordinates;
}

// The joints that move it, and their weights.
uvec4 gaussian_joints(uvec2 words) {
    return uvec4(words.x, words.x >> 8u, words.x >> 16u, words.x >> 24u) & 0xffu;
}

vec4 gaussian_weights(uvec2 words) {
    uvec3 first = uvec3(words.y, words.y >> 8u, words.y >> 16u) & 0xffu;
    return vec4(first, 255u - first.x - first.y - first.z) / 255.0;
}

// Natural logarithms of the standard deviations, from the first three pairs.
vec3 gaussian_log_scale(uvec2 position, uvec2 skin, uvec2 near) {
    uint codes = position.y >> 16u | skin.y >> 24u << 16u | near.y >> 26u << 24u;
    vec3 steps = vec3(codes & 1023u, codes >> 10u & 1023u, codes >> 20u);
    return frame.log_scale_min + frame.log_scale_step * steps;
}

// Bits of a node's index (layout::compact::NodeBits).
uint node_bits() {
    return uint(findMSB(max(frame.nodes, 1u << NODE_BITS_MIN) - 1u)) + 1u;
}

// The nodes that move it, by falling weight, and their weights. Stored are the first's share of
// what exceeds a third, and the second's share of what exceeds half of the rest.
uvec3 gaussian_nodes(uvec2 words) {
    uint bits = node_bits(), mask = (1u << bits) - 1u;
    return uvec3(words.x, words.x >> bits, words.y) & mask;
}

vec3 gaussian_node_weights(uvec2 words) {
    uint bits = node_bits(), spare = 16u - bits;
    // Shifted twice: 32 at once would be undefined.
    uint high = words.x >> 16u >> (2u * bits - 16u);
    uvec2 steps = uvec2(32u << 2u * spare, 32u << spare) - 1u;
    uvec2 codes = uvec2(high << 5u | words.y >> bits & 31u, words.y >> bits + 5u & steps.y);
    vec2 share = vec2(codes) / vec2(steps);
    float first = (1.0 + 2.0 * share.x) / 3.0;
    float second = (1.0 - first) * (0.5 + 0.5 * share.y);
    return vec3(first, second, 1.0 - first - second);
}

// Unit quaternion w x y z, in (x, y, z, w) of the vector.
vec4 gaussian_rotation(uint word) {
    vec3 codes = vec3(word & 1023u, word >> 10u & 1023u, word >> 20u & 1023u);
    vec3 other = (codes - 512.0) / QUATERNION_STEPS;
    float largest = sqrt(max(1.0 - dot(other, other), 0.0));
    uint at = word >> 30u;
    return at == 0u   ? vec4(largest, other)
           : at == 1u ? vec4(other.x, largest, other.yz)
           : at == 2u ? vec4(other.xy, largest, other.z)
                      : vec4(other, largest);
}
