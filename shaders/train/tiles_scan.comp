// Turns the blocks' counts of pairs into where their pairs begin. Where they do not fit, there are
// none, and the status says how much room they would have needed: the step is repeated with more.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"
#include "common/control.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer ControlBuffer { Control control; };
layout(std430, set = 0, binding = 2) buffer Blocks { uint blocks[]; };
layout(std430, set = 0, binding = 3) buffer PairControlBuffer { Control pair_control; };
// Most pairs that a band had; views that had none.
layout(std430, set = 0, binding = 4) buffer Status { uint status[]; };

shared uint sums[TRAIN_WORKGROUP];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint count = (control.visible_count + TRAIN_BLOCK - 1u) / TRAIN_BLOCK;
    uint run = (count + TRAIN_WORKGROUP - 1u) / TRAIN_WORKGROUP;
    uint first = min(thread * run, count), end = min(first + run, count);
    uint sum = 0u;
    for (uint at = first; at < end; ++at) {
        sum += blocks[at];
    }
    sums[thread] = sum;
    barrier();
    uint next = 0u;
    uint total = 0u;
    for (uint k = 0u; k < TRAIN_WORKGROUP; ++k) {
        next += k < thread ? sums[k] : 0u;
        // A sum that overflows is no sum that fits.
        total = min(total, 0x7fffffffu) + min(sums[k], 0x7fffffffu);
    }
    for (uint at = first; at < end; ++at) {
        uint own = blocks[at];
        blocks[at] = next;
        next += own;
    }
    if (thread == 0u) {
        status[0] = max(status[0], total);
        // The first band is cut up once, on the way there.
        status[1] += block.band.z != 0u && control.visible_count == 0u ? 1u : 0u;
        pair_control.key_count = total <= PAIR_CAPACITY ? total : 0u;
    }
}
