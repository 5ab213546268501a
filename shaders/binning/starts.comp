// Finds where each bin's pairs begin in the sorted order, by bisection.
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
        uint middle = (low + high) / 2u;
        bool before = bin_at(middle) < bin;
        low = before ? middle + 1u : low;
        high = before ? high : middle;
    }
    bins[STARTS_START + bin] = low;
}
