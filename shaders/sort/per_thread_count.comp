// `count` with counters of its own for each invocation.
#version 450
#extension GL_GOOGLE_include_directive : require
#define SHARED_COUNTS
#include "sort/pass.glsl"
#include "sort/entries.glsl"
#include "sort/per_thread.glsl"

layout(local_size_x = SORT_RUNS) in;

void main() {
    uint run = gl_LocalInvocationID.x;
    uint tile = gl_WorkGroupID.x;
    uint end = entry_count();
    if (tile >= tiles_of(end)) {
        return;
    }
    if (FIRST && tile == 0u) {
        for (uint w = run; w < SORT_STATE + 3u * SORT_DIGITS; w += SORT_RUNS) {
            counts[STATE_START + w] = 0u;
        }
    }
    count_run(run, tile, end);
    memoryBarrierBuffer();
    barrier();
    uint runs = opaque_end(SORT_RUNS, end);
    for (uint digit = run; digit < SORT_DIGITS; digit += SORT_RUNS) {
        uint sum = 0u;
        for (uint r = 0u; r < runs; ++r) {
            sum += counts[counter(digit, r)];
        }
        counts[tile * SORT_DIGITS + digit] = sum;
    }
}
