// The entries that a pass writes.
layout(std430, set = 0, binding = 4) writeonly buffer Sorted { uint sorted[]; };

void put(uint place, uint key, uint value) {
    if (WRITES == VALUES) {
        sorted[place] = value;
    } else if (WRITES == PACKED) {
        sorted[place] = (key >> SHIFT + 8u & DIGIT_MASK) << 24u | value;
    } else {
        sorted[2u * place] = key;
        sorted[2u * place + 1u] = value;
    }
}
