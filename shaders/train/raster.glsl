// What blending and its derivative share. A workgroup a tile; an invocation has every so many rows
// of a column.
layout(local_size_x_id = 1, local_size_x = 8) in;
layout(constant_id = 0) const uint TILE = 8u;
// Pairs between two looks at whether the tile is full.
layout(constant_id = 2) const uint BATCH = 32u;
const uint PIXELS = TILE * TILE / gl_WorkGroupSize.x;
// Rows between two pixels of an invocation.
const uint STEP = gl_WorkGroupSize.x / TILE;

shared uint is_open;

// A pixel that lets less light through than this is full: nothing behind it is blended.
#define FULL TRAIN_FULL

// Rows of an invocation's pixels that a splat reaches: from x to before y. `first`: its first row.
// Loops over pixels are unrolled, and rows that it does not reach masked: an array whose index is
// known when it runs lies in memory, which costs more.
uvec2 rows_of(vec4 center_radius, float first) {
    vec2 ends = (center_radius.y + vec2(-1.0, 1.0) * center_radius.w - 0.5 - first) / float(STEP);
    float low = clamp(ceil(ends.x), 0.0, float(PIXELS));
    float high = clamp(floor(ends.y) + 1.0, 0.0, float(PIXELS));
    return uvec2(low, high);
}

// o exp(−½ dᵀ Σ⁻¹ d), which may be above ALPHA_MAX. `shape`: Σ⁻¹ and the opacity.
float alpha_at(vec4 shape, vec2 d) {
    return shape.w * exp(-0.5 * (shape.x * d.x * d.x + shape.z * d.y * d.y) - shape.y * d.x * d.y);
}
