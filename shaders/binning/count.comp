// Counts the pairs of each block of splats, for each side that bins may have, and clears the marks
// (on WebGPU the host does).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "binning/boxes.glsl"

shared uint sums[BIN_SIDES];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint block = gl_WorkGroupID.x;
#ifndef WEB
    for (uint w = thread; w < BIN_BLOCK / 32u; w += BIN_WORKGROUP) {
        MARK_WORD(block * (BIN_BLOCK / 32u) + w) = 0u;
    }
#endif
    if (block * BIN_BLOCK >= control.visible_count) {
        return;
    }
    for (uint k = thread; k < BIN_SIDES; k += BIN_WORKGROUP) {
        sums[k] = 0u;
    }
    barrier();
    uint end = min((block + 1u) * BIN_BLOCK, control.visible_count);
    uint own[BIN_SIDES];
    for (uint k = 0u; k < BIN_SIDES; ++k) {
        own[k] = 0u;
    }
    for (uint place = block * BIN_BLOCK + thread; place < end; place += BIN_WORKGROUP) {
        Box box = box_of(splat_at(place));
        for (uint k = 0u; k < BIN_SIDES; ++k) {
            own[k] += pairs_of(box, k);
        }
    }
    for (uint k = 0u; k < BIN_SIDES; ++k) {
        atomicAdd(sums[k], own[k]);
    }
    barrier();
    for (uint k = thread; k < BIN_SIDES; k += BIN_WORKGROUP) {
        bins[COUNTS_START + block * BIN_SIDES + k] = padded(sums[k]);
    }
}
