// A pass of the radix sort: what its kernels share. A pass orders by one 8-bit digit; passes go
// from the lowest digit up. Entries change their form from pass to pass, to take few bytes:
//
//   KEYS     a key a word; its value is its index. Before the first pass.
//   HALVES   the same with two keys of 16 bits a word; the largest stands for SORT_CULLED.
//   PAIRS    a key and a value in turn.
//   PACKED   the digits that are left in the high bits, the value in the VALUE_BITS others. As soon
//            as both fit: with keys of 22 bits and 2^18 values, after the first pass.
//   VALUES   a value a word. After the last pass.
#include "common/platform.glsl"
#include "common/control.glsl"

const uint KEYS = 0u, PAIRS = 1u, PACKED = 2u, VALUES = 3u, HALVES = 4u;
#ifdef WEB
// WebGPU too chooses these when it makes a pipeline; what is computed from them is not a constant
// then, since naga can't translate it.
#define CHOSEN(id, name, initial) \
    layout(constant_id = id) const uint name##_OF_PASS = initial; \
    uint name = name##_OF_PASS;
#else
#define CHOSEN(id, name, initial) PARAMETER(id, uint, name, initial)
#endif
CHOSEN(0, PASS, 0u)
CHOSEN(1, READS, KEYS)
CHOSEN(2, WRITES, VALUES)
// Keys of a tile; tiles and keys for which there is capacity.
PARAMETER(3, uint, TILE, 2048u)
PARAMETER(4, uint, TILES, 1u)
PARAMETER(5, uint, CAPACITY, 1u)
// Whether `scan` has turned the histograms into offsets.
PARAMETER(6, bool, SCANNED, false)
// Bits of the value in the form PACKED.
CHOSEN(9, VALUE_BITS, 24u)

// The first pass reads keys. WebGPU has two modules of a kernel that writes the control then, since
// a barrier must not depend on a buffer that is written.
#ifndef FIRST
DERIVED bool FIRST = READS == KEYS || READS == HALVES;
#endif
DERIVED uint SHIFT = 8u * PASS;
const uint DIGIT_MASK = SORT_DIGITS - 1u;
DERIVED uint VALUE_MASK = (1u << VALUE_BITS) - 1u;

// Where things start in the counts, in words: the tiles' histograms, the state of a sort, the
// histograms of the passes to come, those of groups of tiles, and then either the two areas through
// which the tiles of OneSweep exchange their counts, or the counters of the per-thread kernels.
DERIVED uint STATE_START = TILES * SORT_DIGITS;
DERIVED uint HISTOGRAMS_START = STATE_START + SORT_STATE;
DERIVED uint GROUPS_START = HISTOGRAMS_START + 3u * SORT_DIGITS;
DERIVED uint STATUS_START =
    GROUPS_START + (TILES + SORT_GROUP - 1u) / SORT_GROUP * SORT_DIGITS;
DERIVED uint COUNTERS_START = STATUS_START;

// The bits of a key that no pass before this one has sorted by.
uint rest_of(uint key) { return READS == PACKED ? key >> VALUE_BITS : key >> SHIFT; }

uint digit_of(uint key) { return rest_of(key) & DIGIT_MASK; }

// Whether an entry is sorted: the first pass drops culled keys.
bool is_kept(uint key) { return !FIRST || key != SORT_CULLED; }
