// `sort_count` with counters of their own for each invocation.
#version 450
#extension GL_GOOGLE_include_directive : require
#define LANES
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
    memoryBarrierBuffer();
    barrier();
    uint lanes = untold(SORT_LANES, end);
    for (uint digit = lane; digit < SORT_DIGITS; digit += SORT_LANES) {
        uint sum = 0u;
        for (uint l = 0u; l < lanes; ++l) {
            sum += counts[counter(digit, l)];
        }
        counts[tile * SORT_DIGITS + digit] = sum;
    }
}
