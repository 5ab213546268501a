// How often each digit occurs in each tile. In the first pass it also clears the state of the sort.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sort/pass.glsl"
#include "sort/entries.glsl"

layout(local_size_x = SORT_WORKGROUP) in;
shared uint count[SORT_DIGITS];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint tile = gl_WorkGroupID.x;
    uint end = entry_count();
    if (tile >= tiles_of(end)) {
        return;
    }
    for (uint d = thread; d < SORT_DIGITS; d += SORT_WORKGROUP) {
        count[d] = 0u;
    }
    if (FIRST && tile == 0u) {
        for (uint w = thread; w < SORT_STATE + 3u * SORT_DIGITS; w += SORT_WORKGROUP) {
            counts[STATE_START + w] = 0u;
        }
    }
    barrier();
    uint last = min(end, (tile + 1u) * TILE);
    for (uint from = tile * TILE + thread; from < last; from += ROWS * SORT_WORKGROUP) {
        uint keys[ROWS];
        for (uint r = 0u; r < ROWS; ++r) {
            uint at = from + r * SORT_WORKGROUP;
            keys[r] = at < last ? key_at(at) : 0u;
        }
        for (uint r = 0u; r < ROWS; ++r) {
            if (from + r * SORT_WORKGROUP < last && is_kept(keys[r])) {
                atomicAdd(count[digit_of(keys[r])], 1u);
            }
        }
    }
    barrier();
    for (uint d = thread; d < SORT_DIGITS; d += SORT_WORKGROUP) {
        counts[tile * SORT_DIGITS + d] = count[d];
    }
}
