// The entries that a pass reads, and their counts.
layout(std430, set = 0, binding = 1) readonly buffer Entries { uint entry[]; };
// A row of SORT_DIGITS counts a tile, then what sort.glsl says.
// Lanes read each other's counters; WGSL has no word for that and needs none.
#if defined(LANES) && !defined(WEB)
#define COUNTS coherent buffer
#else
#define COUNTS buffer
#endif
layout(std430, set = 0, binding = 2) COUNTS Counts { uint counts[]; };
layout(std430, set = 0, binding = 3) buffer ControlBuffer { Control control; };

// Entries that this pass reads.
uint entries() { return min(FIRST ? ENTERING : control.survivors, CAPACITY); }

// Tiles that have entries; one where none has.
uint tiles_of(uint end) { return max((end + TILE - 1u) / TILE, 1u); }

uint key_at(uint at) {
    if (READS == HALVES) {
        uint key = entry[at >> 1u] >> 16u * (at & 1u) & 0xffffu;
        return key == 0xffffu ? SORT_DROPPED : key;
    }
    return READS == PAIRS ? entry[2u * at] : entry[at];
}

uint value_at(uint at, uint key) { return FIRST ? at : READS == PAIRS ? entry[2u * at + 1u] : key & VALUE_MASK; }
