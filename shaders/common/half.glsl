// Half quads: four f16 in eight bytes. Read as two words and unpacked: native 16-bit access was no
// faster where it was measured, and not every device has it.
vec4 widen(uvec2 quad) { return vec4(unpackHalf2x16(quad.x), unpackHalf2x16(quad.y)); }
