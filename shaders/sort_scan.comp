// Second kernel of a sort pass: turns the counts into where each tile's entries of each digit go. One workgroup. The sum is the number
// of entries that this pass writes.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sort.glsl"

layout(std430, set = 0, binding = 1) buffer Histograms { uint histogram[]; };
layout(std430, set = 0, binding = 2) buffer ControlBuffer { Control control; };
layout(constant_id = 2) const uint TILES = 1u;

shared uint sums[SORT_SIZE];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint length = TILES * SORT_DIGITS / SORT_SIZE;
    uint start = thread * length;
    uint sum = 0u;
    for (uint k = 0u; k < length; ++k) {
        sum += histogram[start + k];
    }
    sums[thread] = sum;
    barrier();
    for (uint reach = 1u; reach < SORT_SIZE; reach *= 2u) {
        uint before = thread >= reach ? sums[thread - reach] : 0u;
        barrier();
        sums[thread] += before;
        barrier();
    }
    uint base = sums[thread] - sum;
    for (uint k = 0u; k < length; ++k) {
        uint count = histogram[start + k];
        histogram[start + k] = base;
        base += count;
    }
    if (FIRST && thread == SORT_SIZE - 1u) {
        control.survivors = base;
        control.instance_count = (base + RASTER_QUADS - 1u) / RASTER_QUADS;
    }
}
