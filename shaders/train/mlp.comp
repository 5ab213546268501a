// Stage mlp of the training (model.md, step 1): the networks of all parts, each layer's results
// kept for the way back. A workgroup a part and view. Weights stand input by input, so that
// neighbours read neighbours.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_MLP_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Networks { float networks[]; };
layout(std430, set = 0, binding = 2) readonly buffer Inputs { float inputs[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Activations { float activations[]; };

shared float entered[TRAIN_WIDTH_MAX];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint part = gl_WorkGroupID.x;
    uint view = gl_WorkGroupID.y;
    bool sees_expression = part < HEAD_PARTS;
    for (uint i = thread; i < INPUTS; i += TRAIN_MLP_WORKGROUP) {
        entered[i] = i < EXPRESSION_START || sees_expression ? inputs[view * INPUTS + i] : 0.0;
    }
    barrier();
    for (uint layer = 0u; layer < LAYERS; ++layer) {
        uint width = block.layer_inputs[layer];
        uint neurons = block.layer_outputs[layer];
        uint weights = block.layer_weights[layer] + part * width * neurons;
        uint results = (view * PARTS + part) * ACTIVATIONS + block.layer_results[layer];
        float left[TRAIN_WIDTH_MAX / TRAIN_MLP_WORKGROUP];
        for (uint r = 0u; r < TRAIN_WIDTH_MAX / TRAIN_MLP_WORKGROUP; ++r) {
            uint neuron = r * TRAIN_MLP_WORKGROUP + thread;
            if (neuron < neurons) {
                float sum = networks[block.layer_biases[layer] + part * neurons + neuron];
                for (uint i = 0u; i < width; ++i) {
                    sum += entered[i] * networks[weights + i * neurons + neuron];
                }
                sum = clamp(sum, -FEATURE_MAX, FEATURE_MAX);
                if (layer + 1u < LAYERS) {
                    sum = max(sum, block.low_pass.z * sum);
                }
                left[r] = sum;
                activations[results + neuron] = sum;
            }
        }
        barrier();
        for (uint r = 0u; r < TRAIN_WIDTH_MAX / TRAIN_MLP_WORKGROUP; ++r) {
            uint neuron = r * TRAIN_MLP_WORKGROUP + thread;
            if (neuron < neurons) {
                entered[neuron] = left[r];
            }
        }
        barrier();
    }
}
