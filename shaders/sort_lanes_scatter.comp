// Moves each entry to its place, keeping the order of equal digits, with counters of their own for each invocation. Of the first pass it
// counts by itself, for whoever made the keys has counted a tile's together; of the others `sort_lanes_count` has counted.
#version 450
#extension GL_GOOGLE_include_directive : require
#define THREADS SORT_LANES
#define LANES
#include "sort.glsl"
#include "sort_entries.glsl"
#include "sort_sorted.glsl"
// No array of an invocation's own: llvmpipe needs half a minute to compile one that outlives a barrier.
#define START(own) counts[LANES_AT + gl_WorkGroupID.x * LANE_ROW + SORT_DIGITS * SORT_LANES + gl_LocalInvocationID.x * OWN + own]
uint own_end;
#define OWN_END own_end
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
    own_end = untold(OWN, end);
    uint lanes = untold(THREADS, end);
    if (FIRST) {
        count_own_run(lane, tile, end);
    }
    find_starts(lane, tile, tiles);
    memoryBarrierBuffer();
    barrier();
    // Counts become places: an invocation's entries of a digit follow those of the invocations before it.
    for (uint own = 0u; own < own_end; ++own) {
        uint place = START(own);
        for (uint l = 0u; l < lanes; ++l) {
            uint at = counter(lane * OWN + own, l), counted = counts[at];
            counts[at] = place;
            place += counted;
        }
    }
    memoryBarrierBuffer();
    barrier();
    uint run = TILE / THREADS;
    uint from = tile * TILE + lane * run;
    for (uint at = from; at < min(end, from + run); ++at) {
        uint key = key_at(at);
        if (enters(key)) {
            uint next = counter(digit_of(key), lane), place = counts[next];
            counts[next] = place + 1u;
            put(place, key, value_at(at, key));
        }
    }
}
