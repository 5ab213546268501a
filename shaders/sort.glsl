// What the three kernels of a radix sort pass share. A pass orders by the 8-bit digit at SHIFT; passes go from the lowest digit up.
// Before the first pass an entry is a key alone and its value is its index; from then on a key and a value.
#include "sort_control.glsl"

layout(local_size_x = SORT_SIZE) in;
layout(constant_id = 0) const uint SHIFT = 0u;
layout(constant_id = 1) const bool FIRST = true;

uint digit_of(uint key) { return key >> SHIFT & (SORT_DIGITS - 1u); }

// Entries that this pass reads.
#define ENTRIES (FIRST ? control.entering : control.survivors)
