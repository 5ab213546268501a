// The derivative of the networks: from that of the features to that of each layer's sums, before
// the activation. That of weights follows from them and the activations, in adam_networks.comp. A
// workgroup a part and view.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_MLP_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Networks { float networks[]; };
layout(std430, set = 0, binding = 2) readonly buffer Activations { float activations[]; };
// Holds the features' derivatives in the last layer's place; the others' are written.
layout(std430, set = 0, binding = 3) buffer OfSums { float of_sums[]; };

shared float of_outputs[TRAIN_WIDTH_MAX];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint part = gl_WorkGroupID.x;
    uint view = gl_WorkGroupID.y;
    uint own = (view * PARTS + part) * ACTIVATIONS;
    uint last = LAYERS - 1u;
    for (uint neuron = thread; neuron < block.layer_outputs[last]; neuron += TRAIN_MLP_WORKGROUP) {
        of_outputs[neuron] = of_sums[own + block.layer_results[last] + neuron];
    }
    barrier();
    for (uint layer = last; layer > 0u; --layer) {
        uint width = block.layer_inputs[layer];
        uint neurons = block.layer_outputs[layer];
        uint weights = block.layer_weights[layer] + part * width * neurons;
        uint before = own + block.layer_results[layer - 1u];
        float found[TRAIN_WIDTH_MAX / TRAIN_MLP_WORKGROUP];
        for (uint r = 0u; r < TRAIN_WIDTH_MAX / TRAIN_MLP_WORKGROUP; ++r) {
            uint i = r * TRAIN_MLP_WORKGROUP + thread;
            if (i < width) {
                float sum = 0.0;
                for (uint neuron = 0u; neuron < neurons; ++neuron) {
                    sum += of_outputs[neuron] * networks[weights + i * neurons + neuron];
                }
                // The activation's result has the sign of what entered it.
                found[r] = sum * (activations[before + i] > 0.0 ? 1.0 : block.low_pass.z);
                of_sums[before + i] = found[r];
            }
        }
        barrier();
        for (uint r = 0u; r < TRAIN_WIDTH_MAX / TRAIN_MLP_WORKGROUP; ++r) {
            uint i = r * TRAIN_MLP_WORKGROUP + thread;
            if (i < width) {
                of_outputs[i] = found[r];
            }
        }
        barrier();
    }
}
