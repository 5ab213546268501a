// The derivative of the joints' transforms: a workgroup a joint sums over the Gaussians that it
// moves, from a list that was made once, in a fixed order. reference's joints_gradient.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
// Where the Gaussians of each joint begin, POSED_JOINTS + 1 words.
layout(std430, set = 0, binding = 1) readonly buffer Starts { uint starts[]; };
struct Follower {
    uint gaussian;
    float weight;
};
layout(std430, set = 0, binding = 2) readonly buffer Followers { Follower followers[]; };
layout(std430, set = 0, binding = 3) readonly buffer OfSkinning { vec4 of_skinning[]; };
// Of all views, three rows a joint.
layout(std430, set = 0, binding = 4) writeonly buffer OfJoints { vec4 of_joints[]; };

shared vec4 sums[3u * TRAIN_WORKGROUP];

void main() {
    uint joint = gl_WorkGroupID.x;
    uint thread = gl_LocalInvocationID.x;
    vec4 x = vec4(0.0), y = vec4(0.0), z = vec4(0.0);
    for (uint at = starts[joint] + thread; at < starts[joint + 1u]; at += TRAIN_WORKGROUP) {
        Follower follower = followers[at];
        uint first = 3u * follower.gaussian;
        x += follower.weight * of_skinning[first];
        y += follower.weight * of_skinning[first + 1u];
        z += follower.weight * of_skinning[first + 2u];
    }
    sums[3u * thread] = x;
    sums[3u * thread + 1u] = y;
    sums[3u * thread + 2u] = z;
    barrier();
    if (thread < 3u) {
        vec4 sum = vec4(0.0);
        for (uint k = 0u; k < TRAIN_WORKGROUP; ++k) {
            sum += sums[3u * k + thread];
        }
        of_joints[3u * (VIEW * POSED_JOINTS + joint) + thread] = sum;
    }
}
