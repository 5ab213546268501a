// A Gaussian's 32 bytes in the model, as `splats` and `harmonics` read them; src/vulkan/pack.rs writes them. Pairs of words, in planes
// of GAUSSIAN_PAIRS pairs in all:
//
//   two for each Gaussian   x y | z, log scales 0..16 | four joints | three weights, log scales 16..24
//   one for each Gaussian   nodes a b | node c, shares (5 bits each), log scales 24..30
//   one for each Gaussian   quaternion | RGB, opacity
//   four for 32 Gaussians   which of them keep a row of rotation | scale | colour, how many rows of rotation | scale | colour come
//                           before, their first and last part, nothing
//   one for each Gaussian, of avatars with harmonics   RGB as the camera sees it, three f16
//
// The first three pairs say where a Gaussian is and how long: all that is read of one that is not drawn.
#define NODE_STEPS 31.0
#define QUATERNION_STEPS 720.0

// x₀, canonical space, metres.
vec3 gaussian_position(uvec2 words) {
    return frame.position_min.xyz + frame.position_step.xyz * vec3(words.x & 0xffffu, words.x >> 16u, words.y & 0xffffu);
}

// The joints that move it, and their weights.
uvec4 gaussian_joints(uvec2 words) { return uvec4(words.x, words.x >> 8u, words.x >> 16u, words.x >> 24u) & 0xffu; }
vec4 gaussian_weights(uvec2 words) {
    uvec3 first = uvec3(words.y, words.y >> 8u, words.y >> 16u) & 0xffu;
    return vec4(first, 255u - first.x - first.y - first.z) / 255.0;
}

// From the model's three first pairs.
vec3 gaussian_log_scale(uvec2 place, uvec2 skin, uvec2 near) {
    uint codes = place.y >> 16u | skin.y >> 24u << 16u | near.y >> 26u << 24u;
    return frame.log_scale_min + frame.log_scale_step * vec3(codes & 1023u, codes >> 10u & 1023u, codes >> 20u);
}

// The nodes that move it, those that count most first, and their weights: the first's share of what is above a third, and the second's
// of what is above half of the rest.
uvec3 gaussian_nodes(uvec2 words) { return uvec3(words.x & 0xffffu, words.x >> 16u, words.y & 0xffffu); }
vec3 gaussian_node_weights(uvec2 words) {
    vec2 share = vec2(words.y >> 16u & 31u, words.y >> 21u & 31u) / NODE_STEPS;
    float first = (1.0 + 2.0 * share.x) / 3.0;
    float second = (1.0 - first) * (0.5 + 0.5 * share.y);
    return vec3(first, second, 1.0 - first - second);
}

// w x y z, in (x, y, z, w) of the vector; length 1.
vec4 gaussian_rotation(uint word) {
    vec3 other = (vec3(word & 1023u, word >> 10u & 1023u, word >> 20u & 1023u) - 512.0) / QUATERNION_STEPS;
    float largest = sqrt(max(1.0 - dot(other, other), 0.0));
    uint at = word >> 30u;
    return at == 0u ? vec4(largest, other) : at == 1u ? vec4(other.x, largest, other.yz) : at == 2u ? vec4(other.xy, largest, other.z)
                                                                                                   : vec4(other, largest);
}
