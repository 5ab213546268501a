// Chooses the side of the bins, and turns the blocks' counts of pairs into where their pairs begin.
// One workgroup.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"
#include "common/frame.glsl"
#include "common/control.glsl"

layout(local_size_x = BIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) buffer ControlBuffer { Control control; };
layout(std430, set = 0, binding = 2) buffer Bins { uint bins[]; };
#include "common/bins.glsl"

// Pairs of all blocks, low and high halves apart: together they may not fit a word.
shared uint low[BIN_SIDES];
shared uint high[BIN_SIDES];
// Pairs of the blocks of each invocation, and then of it and all before it.
shared uint sums[BIN_WORKGROUP];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint blocks = (control.visible_count + BIN_BLOCK - 1u) / BIN_BLOCK;
    for (uint k = thread; k < BIN_SIDES; k += BIN_WORKGROUP) {
        low[k] = 0u;
        high[k] = 0u;
    }
    barrier();
    uint own[BIN_SIDES];
    for (uint k = 0u; k < BIN_SIDES; ++k) {
        own[k] = 0u;
    }
    // All sides of a block together: one after another, each read would wait for memory.
    for (uint block = thread; block < blocks; block += BIN_WORKGROUP) {
        for (uint k = 0u; k < BIN_SIDES; ++k) {
            // More than fit stay more than fit.
            own[k] = min(own[k] + bins[COUNTS_START + block * BIN_SIDES + k], PAIR_CAPACITY + 1u);
        }
    }
    for (uint k = 0u; k < BIN_SIDES; ++k) {
        atomicAdd(low[k], own[k] & 0xffffu);
        atomicAdd(high[k], own[k] >> 16u);
    }
    barrier();
    uint shift = BIN_SIDES - 1u;
    for (uint k = BIN_SIDES; k > 0u; --k) {
        uint upper = high[k - 1u] + (low[k - 1u] >> 16u);
        bool fits = upper < 1u << 16u &&
                    (upper << 16u | (low[k - 1u] & 0xffffu)) <= PAIR_CAPACITY;
        shift = fits ? k - 1u : shift;
    }
    uint run = (blocks + BIN_WORKGROUP - 1u) / BIN_WORKGROUP;
    uint first = min(thread * run, blocks), end = min(first + run, blocks);
    uint sum = 0u;
    for (uint block = first; block < end; ++block) {
        sum += bins[COUNTS_START + block * BIN_SIDES + shift];
    }
    sums[thread] = sum;
    barrier();
    for (uint step = 1u; step < BIN_WORKGROUP; step *= 2u) {
        uint before = thread >= step ? sums[thread - step] : 0u;
        barrier();
        sums[thread] += before;
        barrier();
    }
    uint next = sums[thread] - sum;
    for (uint block = first; block < end; ++block) {
        uint at = COUNTS_START + block * BIN_SIDES;
        uint count = bins[at + shift];
        bins[at] = next;
        next += count;
    }
    if (thread == BIN_WORKGROUP - 1u) {
        bins[PAIR_COUNT_AT] = next;
        bins[BIN_SHIFT_AT] = shift;
        control.fragments = 0u;
    }
}
