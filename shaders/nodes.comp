// The displacement of each node (model.md, step 3): offset + B_s e, with the features of the node's part. One invocation a node.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "half.glsl"
#include "layout.glsl"

layout(local_size_x = NODES_SIZE) in;
// Planes of half quads, one entry a node: basis_quads planes for each of x, y, z, then offset and, in w, the part.
layout(std430, set = 0, binding = 1) readonly buffer Nodes { HALF_QUAD nodes[]; };
// Features of each part, then a vector for each node.
layout(std430, set = 0, binding = 2) buffer PoseBuffer { vec4 posed[]; };

void main() {
    uint node = gl_GlobalInvocationID.x;
    if (node >= frame.nodes) {
        return;
    }
    vec4 displacement = widen(nodes[3u * frame.basis_quads * frame.nodes + node]);
    uint feature = frame.feature_start + uint(displacement.w) * frame.feature_quads + frame.node_feature;
    displacement.w = 0.0;
    for (uint b = 0u; b < frame.basis_quads; ++b) {
        vec4 e = posed[feature + b];
        displacement.x += dot(widen(nodes[b * frame.nodes + node]), e);
        displacement.y += dot(widen(nodes[(frame.basis_quads + b) * frame.nodes + node]), e);
        displacement.z += dot(widen(nodes[(2u * frame.basis_quads + b) * frame.nodes + node]), e);
    }
    posed[frame.node_start + node] = displacement;
}
