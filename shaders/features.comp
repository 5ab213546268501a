// The network of each part (model.md, step 1): one workgroup a part, one invocation a neuron; θ_p ⊕ θ_e goes in, e comes out.
// Weights stream through once; activations stay in shared memory, sums are f32.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "half.glsl"
#include "layout.glsl"

layout(local_size_x = FEATURES_SIZE) in;
layout(std430, set = 0, binding = 1) readonly buffer Networks { HALF_QUAD networks[]; };
layout(std430, set = 0, binding = 2) writeonly buffer PoseOut { float features[]; };

shared float activation[2 * MLP_WIDTH];

// No weight whatever makes infinity of a feature, nor NaN of two of them.
float within(float sum) { return clamp(sum, -float(FEATURE_MAX), float(FEATURE_MAX)); }

void main() {
    uint part = gl_WorkGroupID.x;
    uint block = part * frame.network_quads;
    uint input_start = part < frame.head_parts ? 0u : INPUT_QUADS;
    uint input_quads = part < frame.head_parts ? frame.layer[0].input_quads : frame.body_quads;
    for (uint l = 0u; l < frame.layers; ++l) {
        Layer layer = frame.layer[l];
        uint source = (l & 1u) * MLP_WIDTH;
        uint target = MLP_WIDTH - source;
        bool last = l + 1u == frame.layers;
        for (uint o = gl_LocalInvocationID.x; o < layer.output_count; o += FEATURES_SIZE) {
            vec4 bias = widen(networks[block + layer.bias + o / 4u]);
            float sum = bias[o & 3u];
            uint weight = block + layer.weight + o;
            uint quads = l == 0u ? input_quads : layer.input_quads;
            for (uint k = 0u; k < quads; ++k) {
                vec4 x;
                if (l == 0u) {
                    x = frame.network_input[input_start + k];
                } else {
                    uint at = source + 4u * k;
                    x = vec4(activation[at], activation[at + 1u], activation[at + 2u], activation[at + 3u]);
                }
                sum += dot(widen(networks[weight + k * layer.output_count]), x);
            }
            if (last) {
                features[4u * (frame.feature_start + part * frame.feature_quads) + o] = within(sum);
            } else {
                sum = within(sum);
                activation[target + o] = max(sum, frame.slope * sum);
            }
        }
        barrier();
    }
}
