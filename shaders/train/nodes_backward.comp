// The derivative of the nodes' displacements: each node sums over the Gaussians that follow it,
// from a list that was made once, so that nothing is scattered.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
// Where each node's followers begin, NODES + 1 words.
layout(std430, set = 0, binding = 1) readonly buffer Starts { uint starts[]; };
struct Follower {
    uint gaussian;
    float weight;
};
layout(std430, set = 0, binding = 2) readonly buffer Followers { Follower followers[]; };
layout(std430, set = 0, binding = 3) readonly buffer OfGaussians { vec4 of_gaussians[]; };
layout(std430, set = 0, binding = 4) writeonly buffer OfNodes { vec4 of_nodes[]; };
#include "train/gradient.glsl"

void main() {
    uint node = gl_GlobalInvocationID.x;
    uint view = gl_WorkGroupID.y;
    if (node >= NODES) {
        return;
    }
    vec3 sum = vec3(0.0);
    for (uint at = starts[node]; at < starts[node + 1u]; ++at) {
        Follower follower = followers[at];
        sum += follower.weight * of_gaussians[gradient_at(view, follower.gaussian) + 3u].xyz;
    }
    of_nodes[view * NODES + node] = vec4(sum, 0.0);
}
