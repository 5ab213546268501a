// What the kernels that make pairs share: the drawing order in blocks of BIN_BLOCK, nearest first,
// and the bins that a splat's box meets.
#include "common/platform.glsl"
#include "common/frame.glsl"
#include "common/splat.glsl"
#include "common/control.glsl"
#include "common/tiles.glsl"

layout(local_size_x = BIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Order { uint order[]; };
layout(std430, set = 0, binding = 2) readonly buffer Splats { uvec4 splats[]; };
layout(std430, set = 0, binding = 3) readonly buffer ControlBuffer { Control control; };
layout(std430, set = 0, binding = 4) buffer Bins { uint bins[]; };
#include "common/bins.glsl"

// The finest bins that a splat's box meets: columns and rows of the first and last. None: `empty`.
struct Box {
    uvec2 low;
    uvec2 high;
    bool empty;
};

// `place`: in the drawing order, nearest first.
uint splat_at(uint place) { return order[control.visible_count - 1u - place]; }

Box box_of(uint i) {
    Splat splat = unpack_splat(splats[i]);
    vec2 half_sides = half_box(splat, radius_of(splat.opacity));
    vec2 low = splat.center - half_sides, high = splat.center + half_sides;
    vec2 last = vec2(bins_of(0u) - 1u);
    float side = float(frame.bin_side);
    Box box;
    box.low = uvec2(clamp(low / side, vec2(0.0), last));
    box.high = uvec2(clamp(high / side, vec2(0.0), last));
    // Written so that NaN fails it.
    box.empty = !(all(lessThan(low, frame.size)) && all(greaterThan(high, vec2(0.0))));
    return box;
}

// How many bins, `shift` times doubled, a box meets.
uint pairs_of(Box box, uint shift) {
    uvec2 sides = (box.high >> shift) - (box.low >> shift) + 1u;
    return box.empty ? 0u : sides.x * sides.y;
}

// Blocks have an even number of pairs, since two keys share a word; the last may be none.
uint padded(uint pairs) { return pairs + (pairs & 1u); }
