// The pose buffer, `posed`, for kernels that read it: features (f32), then the nodes' displacements (three f16 and a spare), then, from
// word frame.surface_start on, the depth surface's pyramid, two texels a word.

// Four features, counted in quads.
vec4 features_of(uint quad) { return uintBitsToFloat(uvec4(posed[2u * quad], posed[2u * quad + 1u])); }

// Metres.
vec3 displacement_of(uint node) {
    uvec2 words = posed[2u * frame.node_start + node];
    return vec3(unpackHalf2x16(words.x), unpackHalf2x16(words.y).x);
}

// Four texels of the pyramid in a row, 0 to 1; the first's number is a multiple of four.
vec4 furthest_of(uint texel) {
    uvec2 words = posed[(frame.surface_start >> 1u) + (texel >> 2u)];
    return vec4(unpackUnorm2x16(words.x), unpackUnorm2x16(words.y));
}
