// `sort_count` with counters of their own for each invocation.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sort.glsl"
#include "sort_entries.glsl"
#include "sort_lanes.glsl"

layout(local_size_x = SORT_LANES) in;

void main() {
    uint lane = gl_LocalInvocationID.x;
    uint tile = gl_WorkGroupID.x;
    uint end = entries();
    if (tile >= tiles_of(end)) {
        return;
    }
    if (FIRST && tile == 0u) {
        for (uint w = lane; w < SORT_STATE + 3u * SORT_DIGITS; w += SORT_LANES) {
            counts[STATE_AT + w] = 0u;
        }
    }
    count_own_run(lane, tile, end);
    barrier();
    for (uint pair = lane; pair < DIGIT_PAIRS; pair += SORT_LANES) {
        uint sums = 0u;
        for (uint l = 0u; l < SORT_LANES; ++l) {
            sums += next[pair * SORT_LANES + l];
        }
        counts[tile * SORT_DIGITS + 2u * pair] = sums & 0xffffu;
        counts[tile * SORT_DIGITS + 2u * pair + 1u] = sums >> 16u;
    }
}
