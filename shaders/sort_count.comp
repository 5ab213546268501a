// First kernel of a sort pass: how often each digit occurs in each tile of SORT_TILE entries.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sort.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Entries { uint entry[]; };
// Digit-major: counts of digit d are at d · tiles, one a tile.
layout(std430, set = 0, binding = 2) writeonly buffer Histograms { uint histogram[]; };
layout(std430, set = 0, binding = 3) readonly buffer ControlBuffer { Control control; };

shared uint count[SORT_DIGITS];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint tile = gl_WorkGroupID.x;
    for (uint d = thread; d < SORT_DIGITS; d += SORT_SIZE) {
        count[d] = 0u;
    }
    barrier();
    uint end = ENTRIES;
    for (uint round = 0u; round < SORT_ROUNDS; ++round) {
        uint at = tile * SORT_TILE + round * SORT_SIZE + thread;
        if (at < end) {
            uint key = FIRST ? entry[at] : entry[2u * at];
            if (!FIRST || key != SORT_DROPPED) {
                atomicAdd(count[digit_of(key)], 1u);
            }
        }
    }
    barrier();
    for (uint d = thread; d < SORT_DIGITS; d += SORT_SIZE) {
        histogram[d * gl_NumWorkGroups.x + tile] = count[d];
    }
}
