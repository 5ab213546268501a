// A Gaussian's 32 bytes in the model buffer, as `project` and `sh` read them; written by
// layout::pack. Pairs of words, in planes, GAUSSIAN_PAIRS pairs a Gaussian:
//
//   two a Gaussian           x y | z, log scales 0..16 | four joints | three weights, log scales
//                            16..24
//   one a Gaussian           nodes a b | node c, shares (5 bits each), log scales 24..30
//   one a Gaussian           quaternion | RGB, opacity
//   four for 32 Gaussians    masks of those that have a basis row of rotation | scale | colour,
//                            number of earlier rows of rotation | scale | colour, first and last
//                            part, unused
//   one a Gaussian           RGB as the camera sees it, three f16; with spherical harmonics only
//
// The first three pairs give a Gaussian's position and size: nothing else is read of a culled one.

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

// The nodes that move it, by falling weight, and their weights. Stored are the first's share of
// what exceeds a third, and the second's share of what exceeds half of the rest.
uvec3 gaussian_nodes(uvec2 words) {
    return uvec3(words.x & 0xffffu, words.x >> 16u, words.y & 0xffffu);
}

vec3 gaussian_node_weights(uvec2 words) {
    vec2 share = vec2(words.y >> 16u & 31u, words.y >> 21u & 31u) / NODE_STEPS;
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
