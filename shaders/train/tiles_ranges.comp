// Finds where the pairs of each tile of the band begin in the sorted order, by bisection.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"
#include "common/control.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer PairControlBuffer { Control pair_control; };
layout(std430, set = 0, binding = 2) readonly buffer PairOrder { uint pair_order[]; };
layout(std430, set = 0, binding = 3) readonly buffer PairKeys { uint pair_keys[]; };
layout(std430, set = 0, binding = 4) writeonly buffer Ranges { uint ranges[]; };

void main() {
    uint tile = gl_GlobalInvocationID.x;
    if (tile > block.image_size.z * (block.band.y - block.band.x)) {
        return;
    }
    uint low = 0u, high = pair_control.key_count;
    while (low < high) {
        uint middle = (low + high) / 2u;
        bool before = pair_keys[pair_order[middle]] < tile;
        low = before ? middle + 1u : low;
        high = before ? high : middle;
    }
    ranges[tile] = low;
}
