// A corner of the occluder mesh, which lies inside the avatar: moved by its nodes, skinned as a
// Gaussian is (model.md, steps 4 and 6) and pushed back by the margin. Depth is 1 less the key that
// splats are sorted by: 0 at the nearest key and 1 at the furthest.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/frame.glsl"
#include "common/depth_key.glsl"

// Two vectors a corner: position in 16-bit coordinates (x y, z), joints, weights; three nodes (x y,
// z) and the weights of the first two.
layout(std430, set = 0, binding = 1) readonly buffer Corners { uvec4 corners[]; };
layout(std430, set = 0, binding = 2) readonly buffer PoseBuffer { uvec2 pose[]; };
#include "common/pose.glsl"

void main() {
    uvec4 corner = corners[2 * gl_VertexIndex];
    uvec4 near = corners[2 * gl_VertexIndex + 1];
    vec3 coordinates = vec3(corner.x & 0xffffu, corner.x >> 16u, corner.y);
    vec4 x = vec4(frame.position_min.xyz + frame.position_step.xyz * coordinates, 1.0);
    vec2 share = unpackUnorm2x16(near.z);
    x.xyz += share.x * displacement_of(near.x & 0xffffu) +
             share.y * displacement_of(near.x >> 16u) +
             (1.0 - share.x - share.y) * displacement_of(near.y);
    uvec4 joint = uvec4(corner.z, corner.z >> 8u, corner.z >> 16u, corner.z >> 24u) & 0xffu;
    vec4 weight = unpackUnorm4x8(corner.w);
    vec3 p = vec3(0.0);
    for (uint k = 0u; k < 4u; ++k) {
        uint at = 3u * joint[k];
        p += weight[k] * vec3(dot(frame.joint[at], x), dot(frame.joint[at + 1u], x),
                              dot(frame.joint[at + 2u], x));
    }
    vec2 at = frame.focal * p.xy + frame.center * p.z;
    float depth = 1.0 - key_of(p.z + frame.occluder_margin);
#ifdef WEB
    // WebGPU's viewports must lie inside their images, so the shader maps the image to its part of
    // the view.
    at = (at - frame.occluder_origin * p.z) * frame.occluder_scale;
    gl_Position = vec4(2.0 * at / float(PYRAMID_SIDE) - p.z, depth * p.z, p.z);
#else
    gl_Position = vec4(2.0 * at / frame.size - p.z, depth * p.z, p.z);
#endif
}
