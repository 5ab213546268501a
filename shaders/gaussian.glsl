// What `harmonics` reads and writes of a Gaussian's words in the model: `splats` reads the same (src/vulkan/model.rs).

// Plane 0: x₀, canonical space, metres.
vec3 gaussian_position(uvec4 words) {
    return frame.position_min.xyz + frame.position_step.xyz * vec3(words.x & 0xffffu, words.x >> 16u, words.y & 0xffffu);
}

// Plane 0: the joints that move it, and their weights.
uvec4 gaussian_joints(uvec4 words) { return uvec4(words.z, words.z >> 8u, words.z >> 16u, words.z >> 24u) & 0xffu; }
vec4 gaussian_weights(uvec4 words) { return unpackUnorm4x8(words.w); }

// Plane 2, first two words: RGB, three f16; what else they hold stays.
uvec2 gaussian_color(uvec2 words, vec3 color) {
    return uvec2(packHalf2x16(color.rg), packHalf2x16(vec2(color.b, 0.0)) | words.y & 0xffff0000u);
}
