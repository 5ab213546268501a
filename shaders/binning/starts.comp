// Finds where each bin's pairs begin in the sorted order: each step leaves an eighth of what may be
// the place. A step waits for memory twice, however many places it looks at.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"
#include "common/frame.glsl"

layout(local_size_x = BIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Sorted { uint sorted[]; };
layout(std430, set = 0, binding = 2) buffer Bins { uint bins[]; };
#ifdef WEB
layout(std430, set = 0, binding = 3) readonly buffer PairKeys { uint pair_keys[]; };
#endif
#include "common/bins.glsl"

const uint PARTS = 8u;

// Where a part of so many places begins.
uint border(uint length, uint part) {
    return part * (length / PARTS) + part * (length % PARTS) / PARTS;
}

// The bin of the pair at a place of the sorted order.
uint bin_at(uint place) {
    uint pair = sorted[place];
    return PAIR_KEY_WORD(pair >> 1u) >> 16u * (pair & 1u) & 0xffffu;
}

void main() {
    uint bin = gl_GlobalInvocationID.x;
    uvec2 sides = bins_of(bins[BIN_SHIFT_AT]);
    if (bin > sides.x * sides.y) {
        return;
    }
    // The pairs that the sort left: those that are none are gone.
    uint low = 0u, high = bins[SORTED_COUNT_AT];
    while (low < high) {
        uint length = high - low;
        uint found[PARTS - 1u];
        for (uint k = 0u; k < PARTS - 1u; ++k) {
            found[k] = bin_at(low + border(length, k + 1u));
        }
        uint first = low;
        for (uint k = 0u; k < PARTS - 1u; ++k) {
            uint place = first + border(length, k + 1u);
            bool before = found[k] < bin;
            low = before ? place + 1u : low;
            high = before ? high : min(high, place);
        }
    }
    bins[STARTS_START + bin] = low;
}
