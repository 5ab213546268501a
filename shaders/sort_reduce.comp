// With more tiles than a scatter can sum: adds up the histograms of each group of SORT_GROUP tiles.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sort.glsl"
#include "sort_entries.glsl"

layout(local_size_x = SORT_SIZE) in;

void main() {
    uint group = gl_WorkGroupID.x;
    uint tiles = tiles_of(entries());
    for (uint d = gl_LocalInvocationID.x; d < SORT_DIGITS; d += SORT_SIZE) {
        uint sum = 0u;
        for (uint tile = group * SORT_GROUP; tile < min(tiles, (group + 1u) * SORT_GROUP); ++tile) {
            sum += counts[tile * SORT_DIGITS + d];
        }
        counts[GROUPS_AT + group * SORT_DIGITS + d] = sum;
    }
}
