// Moves each entry to its place, keeping the order of equal digits, with counters of its own for
// each invocation. In the first pass it counts itself, since the kernel that made the keys counted
// each tile as a whole; in the others `per_thread_count` has counted.
#version 450
#extension GL_GOOGLE_include_directive : require
#define THREADS SORT_RUNS
#define SHARED_COUNTS
#include "sort/pass.glsl"
#include "sort/entries.glsl"
#include "sort/output.glsl"
#include "sort/per_thread.glsl"

// The offsets are in the counts: llvmpipe takes half a minute to compile an invocation's own array
// if it is used after a barrier.
const uint OWN = SORT_DIGITS / THREADS;
uint own_end;

uint offset_at(uint own) {
    uint row = COUNTERS_START + gl_WorkGroupID.x * COUNTERS_PER_TILE;
    return row + SORT_DIGITS * SORT_RUNS + gl_LocalInvocationID.x * OWN + own;
}
uint own_offset(uint own) { return counts[offset_at(own)]; }
void set_own_offset(uint own, uint value) { counts[offset_at(own)] = value; }
#include "sort/offsets.glsl"

layout(local_size_x = THREADS) in;

void main() {
    uint run = gl_LocalInvocationID.x;
    uint tile = gl_WorkGroupID.x;
    uint end = entry_count();
    uint tiles = tiles_of(end);
    if (tile >= tiles) {
        return;
    }
    own_end = opaque_end(OWN, end);
    uint runs = opaque_end(THREADS, end);
    if (FIRST) {
        count_run(run, tile, end);
    }
    find_offsets(run, tile, tiles);
    memoryBarrierBuffer();
    barrier();
    // Counts become offsets: an invocation's entries of a digit follow those of earlier
    // invocations.
    for (uint own = 0u; own < own_end; ++own) {
        uint next = own_offset(own);
        for (uint r = 0u; r < runs; ++r) {
            uint at = counter(run * OWN + own, r), counted = counts[at];
            counts[at] = next;
            next += counted;
        }
    }
    memoryBarrierBuffer();
    barrier();
    uint size = TILE / THREADS;
    uint from = tile * TILE + run * size;
    for (uint at = from; at < min(end, from + size); ++at) {
        uint key = key_at(at);
        if (is_kept(key)) {
            uint offset_at = counter(digit_of(key), run), offset = counts[offset_at];
            counts[offset_at] = offset + 1u;
            write_entry(offset, key, value_at(at, key));
        }
    }
}
