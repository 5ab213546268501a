// After `reduce`: turns the counts of each tile into offsets, a workgroup a group of tiles.
#version 450
#extension GL_GOOGLE_include_directive : require
#define THREADS SORT_WORKGROUP
#include "sort/pass.glsl"
#include "sort/entries.glsl"
#include "sort/shared_offsets.glsl"
#include "sort/offsets.glsl"

layout(local_size_x = THREADS) in;

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint group = gl_WorkGroupID.x;
    uint tiles = tiles_of(entry_count());
    uint groups = (tiles + SORT_GROUP - 1u) / SORT_GROUP;
    if (group >= groups) {
        return;
    }
    sum_rows(thread, GROUPS_START, group, groups);
    for (uint d = thread; d < SORT_DIGITS; d += THREADS) {
        uint next = offset[d], end = min(tiles, (group + 1u) * SORT_GROUP);
        for (uint tile = group * SORT_GROUP; tile < end; tile += ROWS) {
            uint found[ROWS];
            for (uint r = 0u; r < ROWS; ++r) {
                found[r] = tile + r < end ? counts[(tile + r) * SORT_DIGITS + d] : 0u;
            }
            for (uint r = 0u; r < ROWS; ++r) {
                if (tile + r < end) {
                    counts[(tile + r) * SORT_DIGITS + d] = next;
                }
                next += found[r];
            }
        }
    }
}
