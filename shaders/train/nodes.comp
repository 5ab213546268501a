// Stage nodes of the training (model.md, step 3): the displacement of each position node.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Offsets { float offsets[]; };
layout(std430, set = 0, binding = 2) readonly buffer Bases { float bases[]; };
layout(std430, set = 0, binding = 3) readonly buffer Parts { uint node_part[]; };
layout(std430, set = 0, binding = 4) readonly buffer Activations { float activations[]; };
layout(std430, set = 0, binding = 5) writeonly buffer Displaced { vec4 displaced[]; };
#include "train/features.glsl"

void main() {
    uint node = gl_GlobalInvocationID.x;
    uint view = gl_WorkGroupID.y;
    if (node >= NODES) {
        return;
    }
    vec3 moved = vec3(offsets[3u * node], offsets[3u * node + 1u], offsets[3u * node + 2u]);
    if (HAS_CORRECTIVES) {
        uint features = features_at(view, node_part[node]) + TRAIN_BASIS;
        for (uint c = 0u; c < 3u; ++c) {
            float sum = 0.0;
            for (uint k = 0u; k < TRAIN_BASIS; ++k) {
                sum += bases[(3u * node + c) * TRAIN_BASIS + k] * activations[features + k];
            }
            moved[c] += sum;
        }
    }
    displaced[view * NODES + node] = vec4(moved, 0.0);
}
