// Adam of the networks: the derivative of a weight is the sum over the views of what entered times
// the derivative of the neuron's sum. A workgroup a part.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_BASES_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Status { uint status[]; };
layout(std430, set = 0, binding = 2) readonly buffer Inputs { float inputs[]; };
layout(std430, set = 0, binding = 3) readonly buffer Activations { float activations[]; };
layout(std430, set = 0, binding = 4) readonly buffer OfSums { float of_sums[]; };
layout(std430, set = 0, binding = 5) buffer Networks { float networks[]; };
layout(std430, set = 0, binding = 6) buffer FirstMoments { float first_moments[]; };
layout(std430, set = 0, binding = 7) buffer SecondMoments { float second_moments[]; };
#include "train/adam.glsl"

void update(uint at, float gradient, float decay) {
    Moments moments = Moments(first_moments[at], second_moments[at]);
    float rate = block.rates_other.z;
    networks[at] = adam_step(networks[at], gradient, rate, decay, block.adam_correction.zw, moments);
    first_moments[at] = moments.m;
    second_moments[at] = moments.v;
}

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint part = gl_WorkGroupID.x;
    if (status[0] > PAIR_CAPACITY || !HAS_CORRECTIVES) {
        return;
    }
    bool sees_expression = part < HEAD_PARTS;
    for (uint layer = 0u; layer < LAYERS; ++layer) {
        uint width = block.layer_inputs[layer];
        uint neurons = block.layer_outputs[layer];
        uint weights = block.layer_weights[layer] + part * width * neurons;
        for (uint at = thread; at < width * neurons; at += TRAIN_BASES_WORKGROUP) {
            uint i = at / neurons;
            uint neuron = at - i * neurons;
            float gradient = 0.0;
            for (uint view = 0u; view < VIEWS; ++view) {
                uint own = (view * PARTS + part) * ACTIVATIONS;
                float entered;
                if (layer > 0u) {
                    entered = activations[own + block.layer_results[layer - 1u] + i];
                } else {
                    entered = i < EXPRESSION_START || sees_expression ? inputs[view * INPUTS + i] : 0.0;
                }
                gradient += entered * of_sums[own + block.layer_results[layer] + neuron];
            }
            update(weights + at, gradient, block.rates_other.w);
        }
        for (uint neuron = thread; neuron < neurons; neuron += TRAIN_BASES_WORKGROUP) {
            float gradient = 0.0;
            for (uint view = 0u; view < VIEWS; ++view) {
                uint own = (view * PARTS + part) * ACTIVATIONS;
                gradient += of_sums[own + block.layer_results[layer] + neuron];
            }
            // AdamW of PyTorch lets biases decay too.
            update(block.layer_biases[layer] + part * neurons + neuron, gradient, block.rates_other.w);
        }
    }
}
