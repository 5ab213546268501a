// The entries that a pass writes.
layout(std430, set = 0, binding = 4) writeonly buffer Sorted { uint sorted[]; };
#ifndef WEB
// The same, to write a pair at once: entries go far apart, and a GPU writes each place by itself. A
// pass writes through one of the two, as WRITES says, and reads neither.
layout(std430, set = 0, binding = 4) writeonly buffer SortedPairs { uvec2 sorted_pairs[]; };
#endif

// What later passes sort by.
uint later_bits(uint key) {
    uint later = rest_of(key) >> 8u;
    return WRITES == PACKED ? later << VALUE_BITS >> VALUE_BITS : later;
}

void write_entry(uint at, uint key, uint value) {
    if (WRITES == VALUES) {
        sorted[at] = value;
    } else if (WRITES == PACKED) {
        sorted[at] = later_bits(key) << VALUE_BITS | value;
    } else {
#ifdef WEB
        sorted[2u * at] = key;
        sorted[2u * at + 1u] = value;
#else
        sorted_pairs[at] = uvec2(key, value);
#endif
    }
}
