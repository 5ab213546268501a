// How often each digit occurs in each tile. The first pass's also clears the state of the sort.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sort.glsl"
#include "sort_entries.glsl"

layout(local_size_x = SORT_SIZE) in;
shared uint count[SORT_DIGITS];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint tile = gl_WorkGroupID.x;
    uint end = entries();
    if (tile >= tiles_of(end)) {
        return;
    }
    for (uint d = thread; d < SORT_DIGITS; d += SORT_SIZE) {
        count[d] = 0u;
    }
    if (FIRST && tile == 0u) {
        for (uint w = thread; w < SORT_STATE + 3u * SORT_DIGITS; w += SORT_SIZE) {
            counts[STATE_AT + w] = 0u;
        }
    }
    barrier();
    for (uint at = tile * TILE + thread; at < min(end, (tile + 1u) * TILE); at += SORT_SIZE) {
        uint key = key_at(at);
        if (enters(key)) {
            atomicAdd(count[digit_of(key)], 1u);
        }
    }
    barrier();
    for (uint d = thread; d < SORT_DIGITS; d += SORT_SIZE) {
        counts[tile * SORT_DIGITS + d] = count[d];
    }
}
