// Reads the pose buffer, `pose`: features (f32), then the nodes' displacements (three f16 and one
// unused), then, from word frame.pyramid_start on, the depth pyramid, two texels a word. The
// including shader declares it as an array of uvec2.

// Four features. `quad`: index of the first, divided by four.
vec4 features_of(uint quad) {
    return uintBitsToFloat(uvec4(pose[2u * quad], pose[2u * quad + 1u]));
}

// Displacement of a node, metres.
vec3 displacement_of(uint node) {
    uvec2 words = pose[2u * frame.node_start + node];
    return vec3(unpackHalf2x16(words.x), unpackHalf2x16(words.y).x);
}

// Four texels of the pyramid in a row, 0 to 1. `texel`: index of the first, a multiple of four.
vec4 pyramid_texels(uint texel) {
    uvec2 words = pose[(frame.pyramid_start >> 1u) + (texel >> 2u)];
    return vec4(unpackUnorm2x16(words.x), unpackUnorm2x16(words.y));
}
