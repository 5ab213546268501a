// The network of each part (model.md, step 1), from θ_p ⊕ θ_e to the features e: a workgroup a
// part, an invocation a neuron. Then the displacement of the part's nodes (step 3), offset + B_s e:
// an invocation a node. Weights stream through once; activations stay in shared memory, sums are
// f32.
#include "common/frame.glsl"
#include "common/opaque.glsl"

layout(local_size_x = MLP_WORKGROUP) in;
#ifdef BYTE_WEIGHTS
// Four weights a word; then, a word a neuron, bias and size of a step, f16.
layout(std430, set = 0, binding = 1) readonly buffer Networks { uint networks[]; };
#else
#include "common/half.glsl"
layout(std430, set = 0, binding = 1) readonly buffer Networks { uvec2 networks[]; };
#endif
// Planes of words, one entry a node: basis_quads planes for each of x, y, z, four basis functions a
// word; then, two words a node, the offset and the size of a step, four f16. Nodes are sorted by
// part.
layout(std430, set = 0, binding = 2) readonly buffer Nodes { uint nodes[]; };
// Index of each part's first node, then the number of nodes.
layout(std430, set = 0, binding = 3) readonly buffer NodeStarts { uint node_starts[]; };
// See common/pose.glsl.
layout(std430, set = 0, binding = 4) writeonly buffer PoseBuffer { uint pose[]; };

shared float activation[2 * MLP_WIDTH];

// Keeps infinity out of the features, and so NaN out of their differences, whatever the weights.
float clamp_feature(float sum) { return clamp(sum, -FEATURE_MAX, FEATURE_MAX); }

#ifdef BYTE_WEIGHTS
vec4 weights_at(uint at) { return unpackSnorm4x8(networks[at]); }
float initial_sum(uint biases, uint neuron) { return 0.0; }
// unpackSnorm4x8 gives 1 for 127 steps.
float finish_sum(uint biases, uint neuron, float sum) {
    vec2 last = unpackHalf2x16(networks[biases + neuron]);
    return last.x + 127.0 * last.y * sum;
}
#else
vec4 weights_at(uint at) { return widen(networks[at]); }
float initial_sum(uint biases, uint neuron) {
    vec4 bias = widen(networks[biases + (neuron >> 2u)]);
    return bias[neuron & 3u];
}
float finish_sum(uint biases, uint neuron, float sum) { return sum; }
#endif

vec4 activations_at(uint at) {
    return vec4(activation[at], activation[at + 1u], activation[at + 2u], activation[at + 3u]);
}

// `e`: index in `activation` at which the nodes' features start.
void move_nodes(uint part, uint e) {
    uint first = node_starts[part] + gl_LocalInvocationID.x;
    for (uint node = first; node < node_starts[part + 1u]; node += MLP_WORKGROUP) {
        vec3 moved = vec3(0.0);
        for (uint b = 0u; b < opaque_end(frame.basis_quads, first); ++b) {
            uint at = e + 4u * b;
            vec4 x = activations_at(at);
            for (uint k = 0u; k < 3u; ++k) {
                uint plane = k * frame.basis_quads + b;
                moved[k] += dot(unpackSnorm4x8(nodes[plane * frame.nodes + node]), x);
            }
        }
        uint last = 3u * frame.basis_quads * frame.nodes + 2u * node;
        vec2 high = unpackHalf2x16(nodes[last + 1u]);
        // unpackSnorm4x8 gives 1 for 127 steps.
        moved = vec3(unpackHalf2x16(nodes[last]), high.x) + 127.0 * high.y * moved;
        moved = clamp(moved, -FEATURE_MAX, FEATURE_MAX);
        uint at = 4u * frame.node_start + 2u * node;
        pose[at] = packHalf2x16(moved.xy);
        pose[at + 1u] = packHalf2x16(vec2(moved.z, 0.0));
    }
}

void main() {
    uint part = gl_WorkGroupID.x;
    if ((frame.idle_parts[part >> 7u][part >> 5u & 3u] >> (part & 31u) & 1u) != 0u) {
        return;
    }
    uint block = part * frame.network_quads;
    uint input_start = part < frame.head_parts ? 0u : INPUT_QUADS;
    uint input_quads = part < frame.head_parts ? frame.layer[0].input_quads : frame.body_quads;
    uint layers = opaque_end(frame.layers, node_starts[part]);
    for (uint l = 0u; l < layers; ++l) {
        Layer layer = frame.layer[l];
        uint source = (l & 1u) * MLP_WIDTH;
        uint target = MLP_WIDTH - source;
        bool last = l + 1u == layers;
        for (uint o = gl_LocalInvocationID.x; o < layer.output_count; o += MLP_WORKGROUP) {
            float sum = initial_sum(block + layer.bias, o);
            uint weight = block + layer.weight + o;
            uint quads = l == 0u ? input_quads : layer.input_quads;
            for (uint k = 0u; k < quads; ++k) {
                vec4 x;
                if (l == 0u) {
                    x = frame.network_input[input_start + k];
                } else {
                    x = activations_at(source + 4u * k);
                }
                sum += dot(weights_at(weight + k * layer.output_count), x);
            }
            sum = clamp_feature(finish_sum(block + layer.bias, o, sum));
            if (last) {
                uint features = 4u * (frame.feature_start + part * frame.feature_quads);
                pose[features + o] = floatBitsToUint(sum);
                activation[target + o] = sum;
            } else {
                activation[target + o] = max(sum, frame.slope * sum);
            }
        }
        barrier();
    }
    // The half of `activation` that the last layer wrote.
    move_nodes(part, (frame.layers & 1u) * MLP_WIDTH + 4u * frame.node_feature);
}
