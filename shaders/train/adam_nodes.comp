// Adam of the nodes' offsets and bases.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Status { uint status[]; };
layout(std430, set = 0, binding = 2) readonly buffer OfNodes { vec4 of_nodes[]; };
layout(std430, set = 0, binding = 3) readonly buffer Activations { float activations[]; };
layout(std430, set = 0, binding = 4) readonly buffer Parts { uint node_part[]; };
// Offsets and, from BASES_START on, bases.
layout(std430, set = 0, binding = 5) buffer Numbers { float numbers[]; };
layout(std430, set = 0, binding = 6) buffer FirstMoments { float first_moments[]; };
layout(std430, set = 0, binding = 7) buffer SecondMoments { float second_moments[]; };
layout(constant_id = 0) const uint BASES_START = 0u;
#include "train/features.glsl"
#include "train/adam.glsl"

void update(uint at, float gradient, float rate, vec2 correction) {
    Moments moments = Moments(first_moments[at], second_moments[at]);
    numbers[at] = adam_step(numbers[at], gradient, rate, 0.0, correction, moments);
    first_moments[at] = moments.m;
    second_moments[at] = moments.v;
}

void main() {
    uint node = gl_GlobalInvocationID.x / TRAIN_BASIS;
    uint k = gl_GlobalInvocationID.x % TRAIN_BASIS;
    if (node >= NODES || status[0] > PAIR_CAPACITY) {
        return;
    }
    vec3 offset = vec3(0.0), basis = vec3(0.0);
    for (uint view = 0u; view < VIEWS; ++view) {
        vec3 of = of_nodes[view * NODES + node].xyz;
        offset += of;
        basis += of * activations[features_at(view, node_part[node]) + TRAIN_BASIS + k];
    }
    if (k < 3u) {
        update(3u * node + k, offset[k], block.rates_other.x, block.adam_correction.xy);
    }
    if (HAS_CORRECTIVES) {
        for (uint c = 0u; c < 3u; ++c) {
            uint at = BASES_START + (3u * node + c) * TRAIN_BASIS + k;
            update(at, basis[c], block.rates_other.y, block.adam_correction.zw);
        }
    }
}
