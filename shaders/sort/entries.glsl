// The entries that a pass reads, and their counts.
layout(std430, set = 0, binding = 1) readonly buffer Entries { uint entry[]; };
// A row of SORT_DIGITS counts a tile, then what sort/pass.glsl says. The invocations of the per-thread
// kernels read each other's: these define SHARED_COUNTS. OneSweep waits for those of others and
// defines POLLED_COUNTS: a read of what may change is made anew each time.
#if defined(POLLED_COUNTS)
layout(std430, set = 0, binding = 2) coherent volatile buffer Counts { uint counts[]; };
#elif defined(SHARED_COUNTS)
layout(std430, set = 0, binding = 2) COHERENT buffer Counts { uint counts[]; };
#else
layout(std430, set = 0, binding = 2) buffer Counts { uint counts[]; };
#endif
layout(std430, set = 0, binding = 3) buffer ControlBuffer { Control control; };

// Rows of counts, or entries, that an invocation reads at a time: one after another, each would
// wait for memory.
const uint ROWS = 8u;

// Entries that this pass reads.
uint entry_count() { return min(FIRST ? KEY_COUNT : control.visible_count, CAPACITY); }

// Tiles that have entries; one if none has.
uint tiles_of(uint end) { return max((end + TILE - 1u) / TILE, 1u); }

uint key_at(uint at) {
    if (READS == HALVES) {
        uint key = entry[at >> 1u] >> 16u * (at & 1u) & 0xffffu;
        return key == 0xffffu ? SORT_CULLED : key;
    }
    return READS == PAIRS ? entry[2u * at] : entry[at];
}

uint value_at(uint at, uint key) {
    return FIRST ? at : READS == PAIRS ? entry[2u * at + 1u] : key & VALUE_MASK;
}
