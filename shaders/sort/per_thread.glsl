// A tile is cut into SORT_RUNS runs of neighbouring entries, one an invocation, each with counters
// of its own. Nothing is atomic and hardly anything waits, which suits CPU drivers, since they
// execute invocations one after another.
//
// The counters are in a storage buffer, on a CPU as near as shared memory: browsers fill shared
// memory with zeros, and SwiftShader compiles a store for every word of it. And the kernel that
// moves entries finds there what the one that counts has left.
#include "common/opaque.glsl"

const uint COUNTERS_PER_TILE = SORT_DIGITS * (SORT_RUNS + 1u);

// Index of an invocation's counter of a digit. Each tile has a row of counters, then its offsets.
uint counter(uint digit, uint run) {
    return COUNTERS_START + gl_WorkGroupID.x * COUNTERS_PER_TILE + digit * SORT_RUNS + run;
}

void count_run(uint run, uint tile, uint end) {
    for (uint digit = 0u; digit < SORT_DIGITS; ++digit) {
        counts[counter(digit, run)] = 0u;
    }
    uint size = TILE / SORT_RUNS;
    uint from = tile * TILE + run * size;
    for (uint at = from; at < min(end, from + size); ++at) {
        uint key = key_at(at);
        if (is_kept(key)) {
            counts[counter(digit_of(key), run)] += 1u;
        }
    }
}
