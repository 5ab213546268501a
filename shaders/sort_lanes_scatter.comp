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
    // Counts become places after the digit's start: an invocation's entries of a digit follow those of the invocations before it.
    for (uint pair = lane; pair < DIGIT_PAIRS; pair += THREADS) {
        uint places = 0u;
        for (uint l = 0u; l < THREADS; ++l) {
            uint counted = next[pair * SORT_LANES + l];
            next[pair * SORT_LANES + l] = places;
            places += counted;
        }
    }
    barrier();
    uint run = TILE / THREADS;
    uint from = tile * TILE + lane * run;
    for (uint at = from; at < min(end, from + run); ++at) {
        uint key = key_at(at);
        if (enters(key)) {
            uint digit = digit_of(key), word = word_of(digit, lane), places = next[word];
            next[word] = places + (1u << shift_of(digit));
            put(start[digit] + (places >> shift_of(digit) & 0xffffu), key, value_at(at, key));
        }
    }
}
