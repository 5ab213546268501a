// The entries that a pass writes.
layout(std430, set = 0, binding = 4) writeonly buffer Sorted { uint sorted[]; };

void write_entry(uint at, uint key, uint value) {
    if (WRITES == VALUES) {
        sorted[at] = value;
    } else if (WRITES == PACKED) {
        sorted[at] = (key >> SHIFT + 8u & DIGIT_MASK) << 24u | value;
    } else {
        sorted[2u * at] = key;
        sorted[2u * at + 1u] = value;
    }
}
