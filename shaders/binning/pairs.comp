// Writes the pairs of each block of splats: an invocation takes every so many pairs, not splats, so
// that a large splat keeps nobody waiting.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "binning/boxes.glsl"
#ifdef WEB
layout(std430, set = 0, binding = 5) writeonly buffer PairKeys { uint pair_keys[]; };
#endif

const uint NO_BIN = 0xffffu;
// Of each splat: where its pairs end in the block, its index, its first bin's column and row, and
// how many columns it meets.
shared uint ends[BIN_BLOCK];
shared uint indices[BIN_BLOCK];
shared uint corners[BIN_BLOCK];
shared uint widths[BIN_BLOCK];

// The bin and the splat of a pair of the block.
struct Pair {
    uint bin;
    uint splat;
};

Pair pair_at(uint number, uint columns) {
    if (number >= ends[BIN_BLOCK - 1u]) {
        return Pair(NO_BIN, 0u);
    }
    // The first splat that ends past it.
    uint k = 0u;
    for (uint step = BIN_BLOCK / 2u; step > 0u; step /= 2u) {
        k += ends[k + step - 1u] <= number ? step : 0u;
    }
    uint within = number - (k > 0u ? ends[k - 1u] : 0u);
    uint row = within / widths[k];
    uint column = (corners[k] & 0xffffu) + within - row * widths[k];
    return Pair(((corners[k] >> 16u) + row) * columns + column, indices[k]);
}

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint block = gl_WorkGroupID.x;
    if (block * BIN_BLOCK >= control.visible_count) {
        return;
    }
    uint shift = bins[BIN_SHIFT_AT];
    for (uint k = thread; k < BIN_BLOCK; k += BIN_WORKGROUP) {
        uint place = block * BIN_BLOCK + k;
        uint pairs = 0u;
        widths[k] = 1u;
        if (place < control.visible_count) {
            uint i = splat_at(place);
            Box box = box_of(i);
            pairs = pairs_of(box, shift);
            indices[k] = i;
            uvec2 low = box.low >> shift;
            corners[k] = low.x | low.y << 16u;
            widths[k] = (box.high.x >> shift) - low.x + 1u;
        }
        ends[k] = pairs;
    }
    barrier();
    for (uint step = 1u; step < BIN_BLOCK; step *= 2u) {
        uint before[BIN_BLOCK / BIN_WORKGROUP];
        for (uint r = 0u; r < BIN_BLOCK / BIN_WORKGROUP; ++r) {
            uint k = r * BIN_WORKGROUP + thread;
            before[r] = k >= step ? ends[k - step] : 0u;
        }
        barrier();
        for (uint r = 0u; r < BIN_BLOCK / BIN_WORKGROUP; ++r) {
            ends[r * BIN_WORKGROUP + thread] += before[r];
        }
        barrier();
    }
    uint columns = bins_of(shift).x;
    uint first = bins[COUNTS_START + block * BIN_SIDES];
    uint end = padded(ends[BIN_BLOCK - 1u]);
    for (uint number = 2u * thread; number < end; number += 2u * BIN_WORKGROUP) {
        Pair a = pair_at(number, columns), b = pair_at(number + 1u, columns);
        bins[PAIRS_START + first + number] = a.splat;
        bins[PAIRS_START + first + number + 1u] = b.splat;
        PAIR_KEY_WORD((first + number) / 2u) = a.bin | b.bin << 16u;
    }
}
