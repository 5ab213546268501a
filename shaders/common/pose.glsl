// Reads the pose buffer, `pose`: features (f32), then the nodes' displacements (three f16 and one
// unused). The including shader declares it as an array of uvec2.

// Four features. `quad`: index of the first, divided by four.
vec4 features_of(uint quad) {
    return uintBitsToFloat(uvec4(pose[2u * quad], pose[2u * quad + 1u]));
}

// Displacement of a node, metres.
vec3 displacement_of(uint node) {
    uvec2 words = pose[2u * frame.node_start + node];
    return vec3(unpackHalf2x16(words.x), unpackHalf2x16(words.y).x);
}
