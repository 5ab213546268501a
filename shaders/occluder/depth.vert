// A corner of the occluder mesh, which lies inside the avatar: moved by its nodes, skinned as a
// Gaussian is (model.md, steps 4 and 6) and pushed back by the margin. Depth is 1 less the key that
// splats are sorted by: 0 at the nearest key and 1 at the furthest.
//
// Skinning moves Gaussians apart where their weights differ, but stretches each one by its own
// matrix only, so gaps open. A corner around which the shell is too thin for that is at depth 1 and
// hides nothing.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/frame.glsl"
#include "common/depth_key.glsl"

// Two vectors a corner: position in 16-bit coordinates (x y, z) and beside z the limit of
// `stretch`, f16, joints, weights; three nodes (x y, z), the weights of the first two, two corners
// beside it.
layout(std430, set = 0, binding = 1) readonly buffer Corners { uvec4 corners[]; };
layout(std430, set = 0, binding = 2) readonly buffer PoseBuffer { uvec2 pose[]; };
#include "common/pose.glsl"

// Canonical position, metres.
vec3 position_of(uvec4 corner) {
    vec3 coordinates = vec3(corner.x & 0xffffu, corner.x >> 16u, corner.y & 0xffffu);
    return frame.position_min.xyz + frame.position_step.xyz * coordinates;
}

// Displacement by the nodes, metres. `near`: the corner's second vector.
vec3 displacement_at(uvec4 near) {
    vec2 share = unpackUnorm2x16(near.z);
    return share.x * displacement_of(near.x & 0xffffu) +
           share.y * displacement_of(near.x >> 16u) +
           (1.0 - share.x - share.y) * displacement_of(near.y);
}

// The rows of the matrix from canonical space to the camera.
mat3x4 skinning_of(uvec4 corner) {
    uvec4 joint = uvec4(corner.z, corner.z >> 8u, corner.z >> 16u, corner.z >> 24u) & 0xffu;
    vec4 weight = unpackUnorm4x8(corner.w);
    mat3x4 rows = mat3x4(0.0);
    for (uint k = 0u; k < 4u; ++k) {
        uint at = 3u * joint[k];
        rows += weight[k] *
                mat3x4(frame.joint[at], frame.joint[at + 1u], frame.joint[at + 2u]);
    }
    return rows;
}

// Position in the camera's space, metres.
vec3 posed(uint index) {
    uvec4 corner = corners[2u * index];
    vec3 x = position_of(corner) + displacement_at(corners[2u * index + 1u]);
    return vec4(x, 1.0) * skinning_of(corner);
}

// How much further a pose spreads the Gaussians around a corner than it stretches each, squared, by
// area. `a`, `b`: two edges as posed; `own_a`, `own_b`: as the corner's matrix alone would pose them.
float stretch(vec3 a, vec3 b, vec3 own_a, vec3 own_b) {
    vec3 area = cross(a, b), own_area = cross(own_a, own_b);
    return dot(area, area) / dot(own_area, own_area);
}

void main() {
    uint index = uint(gl_VertexIndex);
    uvec4 corner = corners[2u * index];
    uvec4 near = corners[2u * index + 1u];
    vec3 x = position_of(corner);
    mat3x4 rows = skinning_of(corner);
    vec3 p = vec4(x + displacement_at(near), 1.0) * rows;
    uvec2 beside = uvec2(near.w & 0xffffu, near.w >> 16u);
    vec3 own_a = vec4(position_of(corners[2u * beside.x]) - x, 0.0) * rows;
    vec3 own_b = vec4(position_of(corners[2u * beside.y]) - x, 0.0) * rows;
    float limit = unpackHalf2x16(corner.y).y;
    // Written so that NaN fails it.
    bool opaque = stretch(posed(beside.x) - p, posed(beside.y) - p, own_a, own_b) <= limit;

    vec2 at = frame.focal * p.xy + frame.center * p.z;
    float depth = opaque ? 1.0 - key_of(p.z + frame.occluder_margin) : 1.0;
#ifdef WEB
    // WebGPU's viewports must lie inside their images, so the shader maps the image to its part of
    // the view.
    at = (at - frame.occluder_origin * p.z) * frame.occluder_scale;
    gl_Position = vec4(2.0 * at / float(PYRAMID_SIDE) - p.z, depth * p.z, p.z);
#else
    gl_Position = vec4(2.0 * at / frame.size - p.z, depth * p.z, p.z);
#endif
}
