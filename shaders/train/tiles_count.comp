// Counts the pairs of splats and tiles of each block of splats.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"
#include "common/control.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer ControlBuffer { Control control; };
layout(std430, set = 0, binding = 2) readonly buffer Order { uint order[]; };
layout(std430, set = 0, binding = 3) readonly buffer Splats { vec4 splats[]; };
layout(std430, set = 0, binding = 4) writeonly buffer Blocks { uint blocks[]; };
#include "train/tiles.glsl"

shared uint sums[TRAIN_WORKGROUP];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint first = gl_WorkGroupID.x * TRAIN_BLOCK + thread * (TRAIN_BLOCK / TRAIN_WORKGROUP);
    uint sum = 0u;
    for (uint k = 0u; k < TRAIN_BLOCK / TRAIN_WORKGROUP; ++k) {
        if (first + k < control.visible_count) {
            sum += count_of(tiles_of(splats[3u * order[first + k]]));
        }
    }
    sums[thread] = sum;
    barrier();
    if (thread == 0u) {
        uint total = 0u;
        for (uint k = 0u; k < TRAIN_WORKGROUP; ++k) {
            total += sums[k];
        }
        blocks[gl_WorkGroupID.x] = total;
    }
}
