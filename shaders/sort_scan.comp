// After `sort_reduce`: turns the counts of each tile into where its entries go, a workgroup a group of tiles.
#version 450
#extension GL_GOOGLE_include_directive : require
#define THREADS SORT_SIZE
#include "sort.glsl"
#include "sort_entries.glsl"
#include "sort_starts.glsl"

layout(local_size_x = THREADS) in;

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint group = gl_WorkGroupID.x;
    uint tiles = tiles_of(entries());
    uint groups = (tiles + SORT_GROUP - 1u) / SORT_GROUP;
    if (group >= groups) {
        return;
    }
    sum_rows(thread, GROUPS_AT, group, groups);
    for (uint d = thread; d < SORT_DIGITS; d += THREADS) {
        uint place = start[d];
        for (uint tile = group * SORT_GROUP; tile < min(tiles, (group + 1u) * SORT_GROUP); ++tile) {
            uint count = counts[tile * SORT_DIGITS + d];
            counts[tile * SORT_DIGITS + d] = place;
            place += count;
        }
    }
}
