// Writes the pairs of each block: the tile of the band as a key, the Gaussian beside it. A Gaussian's pairs lie
// next to each other, so that what the tiles find out about it can be summed in order.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"
#include "common/control.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer ControlBuffer { Control control; };
layout(std430, set = 0, binding = 2) readonly buffer Order { uint order[]; };
layout(std430, set = 0, binding = 3) readonly buffer Splats { vec4 splats[]; };
layout(std430, set = 0, binding = 4) readonly buffer Blocks { uint blocks[]; };
layout(std430, set = 0, binding = 5) readonly buffer PairControlBuffer { Control pair_control; };
layout(std430, set = 0, binding = 6) writeonly buffer PairKeys { uint pair_keys[]; };
layout(std430, set = 0, binding = 7) writeonly buffer PairGaussians { uint pair_gaussians[]; };
layout(std430, set = 0, binding = 8) writeonly buffer SplatPairs { uvec2 splat_pairs[]; };
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
    // None at all, or more than fit.
    bool is_empty = pair_control.key_count == 0u;
    uint next = blocks[gl_WorkGroupID.x];
    for (uint k = 0u; k < thread; ++k) {
        next += sums[k];
    }
    for (uint k = 0u; k < TRAIN_BLOCK / TRAIN_WORKGROUP; ++k) {
        if (first + k < control.visible_count) {
            uint g = order[first + k];
            if (is_empty) {
                splat_pairs[g] = uvec2(0u);
                continue;
            }
            Box box = tiles_of(splats[3u * g]);
            splat_pairs[g] = uvec2(next, count_of(box));
            for (uint y = box.low.y; y < box.end.y; ++y) {
                for (uint x = box.low.x; x < box.end.x; ++x) {
                    pair_keys[next] = (y - block.band.x) * block.image_size.z + x;
                    pair_gaussians[next] = g;
                    ++next;
                }
            }
        }
    }
}
