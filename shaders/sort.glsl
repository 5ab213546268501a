// What the kernels of a radix sort pass share. A pass orders by one 8-bit digit; passes go from the lowest digit up. Entries change
// their form from pass to pass, to be as few bytes as they can be:
//
//   KEYS     a key a word; its value is its index. Before the first pass.
//   HALVES   the same with two keys of 16 bits a word; the largest is SORT_DROPPED.
//   PAIRS    a key and a value in turn.
//   PACKED   the last digit in the high 8 bits, the value in the others. Before the last pass, where values fit.
//   VALUES   a value a word. After the last pass.
#include "sort_control.glsl"

const uint KEYS = 0u, PAIRS = 1u, PACKED = 2u, VALUES = 3u, HALVES = 4u;
#ifdef WEB
// PASS, READS, WRITES and TILE are macros there. A buffer that is written to can't tell how many keys enter: barriers wait for that.
#include "settings.glsl"
#define TILES settings.tiles
#define CAPACITY settings.capacity
#define SCANNED (settings.scanned != 0u)
#define ENTERING settings.entering
#define PLACE uint
#else
layout(constant_id = 0) const uint PASS = 0u;
layout(constant_id = 1) const uint READS = KEYS;
layout(constant_id = 2) const uint WRITES = VALUES;
// Keys of a tile, tiles that there is room for, keys that there is room for.
layout(constant_id = 3) const uint TILE = 2048u;
layout(constant_id = 4) const uint TILES = 1u;
layout(constant_id = 5) const uint CAPACITY = 1u;
// Whether `sort_scan` has turned the histograms into places.
layout(constant_id = 6) const bool SCANNED = false;
#define ENTERING control.entering
#define PLACE const uint
#endif

const bool FIRST = READS == KEYS || READS == HALVES;
const uint SHIFT = 8u * PASS;
const uint DIGIT_MASK = SORT_DIGITS - 1u;
const uint VALUE_MASK = 0xffffffu;

// Where things start in the counts, in words: the tiles' histograms, the state of a sort, the histograms of groups of tiles, and then
// either two areas in which the tiles of a pass tell each other their counts or the counters of the lanes.
PLACE STATE_AT = TILES * SORT_DIGITS;
PLACE AHEAD_AT = STATE_AT + SORT_STATE;
PLACE GROUPS_AT = AHEAD_AT + 3u * SORT_DIGITS;
PLACE STATUS_AT = GROUPS_AT + (TILES + SORT_GROUP - 1u) / SORT_GROUP * SORT_DIGITS;
PLACE LANES_AT = STATUS_AT;
const uint LANE_ROW = SORT_DIGITS * (SORT_LANES + 1u);

uint digit_of(uint key) { return READS == PACKED ? key >> 24u : key >> SHIFT & DIGIT_MASK; }

bool enters(uint key) { return !FIRST || key != SORT_DROPPED; }
