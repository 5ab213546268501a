// Whether a region of the image is drawn, by its first pixel; others are only cleared. An atlas is
// drawn as a whole.
bool is_drawn(uvec2 corner) {
    vec2 at = vec2(corner);
    return frame.area_reach < 0.0 || (all(greaterThanEqual(at, frame.area.xy)) &&
                                      all(lessThan(at, frame.area.zw)));
}

// The place of an invocation in its workgroup, 8 by 8 or 16 by 16. Neighbours in a subgroup of any
// size are neighbours in the image: the bits of the index are, from the lowest, x y x y x y x y.
uvec2 place_of(uint index) {
    uvec2 bits = uvec2(index, index >> 1u);
    return bits & 1u | bits >> 1u & 2u | bits >> 2u & 4u | bits >> 3u & 8u;
}
