// Adds up the histograms of each group of SORT_GROUP tiles, if there are too many tiles for each
// workgroup of `scatter` to sum them all.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sort/pass.glsl"
#include "sort/entries.glsl"

layout(local_size_x = SORT_WORKGROUP) in;

void main() {
    uint group = gl_WorkGroupID.x;
    uint tiles = tiles_of(entry_count());
    for (uint d = gl_LocalInvocationID.x; d < SORT_DIGITS; d += SORT_WORKGROUP) {
        uint sum = 0u, end = min(tiles, (group + 1u) * SORT_GROUP);
        for (uint tile = group * SORT_GROUP; tile < end; tile += ROWS) {
            uint found[ROWS];
            for (uint r = 0u; r < ROWS; ++r) {
                found[r] = tile + r < end ? counts[(tile + r) * SORT_DIGITS + d] : 0u;
            }
            for (uint r = 0u; r < ROWS; ++r) {
                sum += found[r];
            }
        }
        counts[GROUPS_START + group * SORT_DIGITS + d] = sum;
    }
}
