// A convolution, or the derivative of one with respect to what it read. Without zeros between them,
// numbers of what is read lie under a window that moves by STEP; the derivative of a convolution with
// a stride reads as if there were DIVISOR - 1 zeros between two.
//
// A workgroup has a tile of pixels and channels of what is written. It puts what a channel has under
// the tile's windows into shared memory, and the weights of some rows of the window. An invocation
// sums QUADS times four channels of eight pixels: two columns, LANES apart, of four rows. The order
// of every sum is fixed.
#version 450
#extension GL_EXT_control_flow_attributes : require

layout(local_size_x_id = 0, local_size_x = 128) in;
// Columns of invocations.
layout(constant_id = 1) const uint LANES = 16u;
layout(constant_id = 2) const uint QUADS = 2u;
// Invocations over channels; the others are over rows.
layout(constant_id = 3) const uint CHANNEL_GROUPS = 8u;
// Channels that are read and written, the window's side, from a window to the next, zeros before the
// first number.
layout(constant_id = 4) const uint FROM = 1u;
layout(constant_id = 5) const uint TO = 1u;
layout(constant_id = 6) const uint WINDOW = 3u;
layout(constant_id = 7) const uint STEP = 1u;
layout(constant_id = 8) const uint DIVISOR = 1u;
layout(constant_id = 9) const uint PAD = 0u;
layout(constant_id = 10) const uint READ_WIDTH = 1u;
layout(constant_id = 11) const uint READ_HEIGHT = 1u;
layout(constant_id = 12) const uint WIDTH = 1u;
layout(constant_id = 13) const uint HEIGHT = 1u;
// Rows of the window whose weights are in shared memory at once.
layout(constant_id = 14) const uint ROWS = 3u;
// What becomes of a sum: 1: its channel's bias is added; 2: that, and negative numbers become 0; 3:
// it becomes 0 where `kept` is not positive.
layout(constant_id = 15) const uint END = 0u;

const uint TILE_WIDTH = 2u * LANES;
const uint TILE_HEIGHT = 4u * (gl_WorkGroupSize.x / (LANES * CHANNEL_GROUPS));
const uint TILE_QUADS = QUADS * CHANNEL_GROUPS;
const uint REACH_X = (TILE_WIDTH - 1u) * STEP + WINDOW;
const uint REACH_Y = (TILE_HEIGHT - 1u) * STEP + WINDOW;
// Vectors of four channels that are written.
const uint TO_QUADS = (TO + 3u) / 4u;

// Shape: pictures · channels · height · width.
layout(std430, set = 0, binding = 1) readonly buffer Read { float read_maps[]; };
// Shape: channels read · window · window · TO_QUADS.
layout(std430, set = 0, binding = 2) readonly buffer Weights { vec4 weights[]; };
layout(std430, set = 0, binding = 3) readonly buffer Biases { float biases[]; };
layout(std430, set = 0, binding = 4) writeonly buffer Written { float written[]; };
// As large as what is written.
layout(std430, set = 0, binding = 5) readonly buffer Kept { float kept[]; };

shared float reach[REACH_X * REACH_Y];
shared vec4 row_weights[ROWS * WINDOW * TILE_QUADS];

// What is read at a place, in steps of one over DIVISOR.
float read_at(uint plane, ivec2 place) {
    if (any(lessThan(place, ivec2(0))) || any(notEqual(uvec2(place) % DIVISOR, uvec2(0u)))) {
        return 0.0;
    }
    uvec2 at = uvec2(place) / DIVISOR;
    if (at.x >= READ_WIDTH || at.y >= READ_HEIGHT) {
        return 0.0;
    }
    return read_maps[(plane * READ_HEIGHT + at.y) * READ_WIDTH + at.x];
}

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint lane = thread % LANES;
    uint quad = thread / LANES % CHANNEL_GROUPS * QUADS;
    uint row = thread / (LANES * CHANNEL_GROUPS) * 4u;
    uint columns = (WIDTH + TILE_WIDTH - 1u) / TILE_WIDTH;
    uvec2 tile = uvec2(gl_WorkGroupID.x % columns, gl_WorkGroupID.x / columns);
    uvec2 corner = tile * uvec2(TILE_WIDTH, TILE_HEIGHT);
    uint parts = (TO_QUADS + TILE_QUADS - 1u) / TILE_QUADS;
    uint picture = gl_WorkGroupID.y / parts;
    uint first_quad = gl_WorkGroupID.y % parts * TILE_QUADS;

    vec4 sums[QUADS * 8u];
    [[unroll]] for (uint k = 0u; k < QUADS * 8u; ++k) {
        sums[k] = vec4(0.0);
    }
    for (uint channel = 0u; channel < FROM; ++channel) {
        barrier();
        for (uint at = thread; at < REACH_X * REACH_Y; at += gl_WorkGroupSize.x) {
            ivec2 place = ivec2(corner * STEP + uvec2(at % REACH_X, at / REACH_X)) - int(PAD);
            reach[at] = read_at(picture * FROM + channel, place);
        }
        for (uint first = 0u; first < WINDOW; first += ROWS) {
            uint end = min(first + ROWS, WINDOW);
            if (first > 0u) {
                barrier();
            }
            uint taps = (end - first) * WINDOW;
            uint from = (channel * WINDOW + first) * WINDOW;
            for (uint at = thread; at < taps * TILE_QUADS; at += gl_WorkGroupSize.x) {
                uint own = first_quad + at % TILE_QUADS;
                uint tap = from + at / TILE_QUADS;
                row_weights[at] = own < TO_QUADS ? weights[tap * TO_QUADS + own] : vec4(0.0);
            }
            barrier();
            for (uint down = first; down < end; ++down) {
                for (uint across = 0u; across < WINDOW; ++across) {
                    uint tap = ((down - first) * WINDOW + across) * TILE_QUADS + quad;
                    uint start = (row * STEP + down) * REACH_X + lane * STEP + across;
                    [[unroll]] for (uint p = 0u; p < 8u; ++p) {
                        uint at = start + (p / 2u * REACH_X + p % 2u * LANES) * STEP;
                        float number = reach[at];
                        [[unroll]] for (uint q = 0u; q < QUADS; ++q) {
                            sums[8u * q + p] += row_weights[tap + q] * number;
                        }
                    }
                }
            }
        }
    }
    [[unroll]] for (uint p = 0u; p < 8u; ++p) {
        uvec2 at = corner + uvec2(lane + p % 2u * LANES, row + p / 2u);
        [[unroll]] for (uint q = 0u; q < QUADS; ++q) {
            [[unroll]] for (uint k = 0u; k < 4u; ++k) {
                uint channel = 4u * (first_quad + quad + q) + k;
                if (at.x < WIDTH && at.y < HEIGHT && channel < TO) {
                    uint place = ((picture * TO + channel) * HEIGHT + at.y) * WIDTH + at.x;
                    float number = sums[8u * q + p][k];
                    if (END == 1u || END == 2u) {
                        number += biases[channel];
                    }
                    if (END == 2u) {
                        number = max(number, 0.0);
                    }
                    if (END == 3u) {
                        number = kept[place] > 0.0 ? number : 0.0;
                    }
                    written[place] = number;
                }
            }
        }
    }
}
