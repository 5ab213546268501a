// Moves each entry to its place, keeping the order of equal digits, with counters of their own for each invocation.
#version 450
#extension GL_GOOGLE_include_directive : require
#define THREADS SORT_LANES
#include "sort.glsl"
#include "sort_entries.glsl"
#include "sort_sorted.glsl"
#include "sort_starts.glsl"
#include "sort_lanes.glsl"

layout(local_size_x = THREADS) in;

void main() {
    uint lane = gl_LocalInvocationID.x;
    uint tile = gl_WorkGroupID.x;
    uint end = entries();
    uint tiles = tiles_of(end);
    if (tile >= tiles) {
        return;
    }
    count_own_run(lane, tile, end);
    find_starts(lane, tile, tiles);
    // Counts become places: an invocation's entries of a digit follow those of the invocations before it.
    for (uint d = lane; d < SORT_DIGITS; d += THREADS) {
        uint place = start[d];
        for (uint l = 0u; l < THREADS; ++l) {
            uint count = next[d * SORT_LANES + l];
            next[d * SORT_LANES + l] = place;
            place += count;
        }
    }
    barrier();
    uint run = TILE / THREADS;
    uint from = tile * TILE + lane * run;
    for (uint at = from; at < min(end, from + run); ++at) {
        uint key = key_at(at);
        if (enters(key)) {
            uint slot = digit_of(key) * SORT_LANES + lane;
            uint place = next[slot];
            next[slot] = place + 1u;
            put(place, key, value_at(at, key));
        }
    }
}
