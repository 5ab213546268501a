// The derivative of the features: of each part, Bᵀ times those of its Gaussians' correctives and of
// its nodes' displacements. A workgroup a part and view; rows of invocations take every so many
// Gaussians, columns a feature each.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_FEATURES_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer OfGaussians { vec4 of_gaussians[]; };
layout(std430, set = 0, binding = 2) readonly buffer OfNodes { vec4 of_nodes[]; };
layout(std430, set = 0, binding = 3) readonly buffer Bases { float bases[]; };
// Row of rotation, scale and colour of each Gaussian, or TRAIN_NO_ROW.
layout(std430, set = 0, binding = 4) readonly buffer Rows { uvec4 rows[]; };
layout(std430, set = 0, binding = 5) readonly buffer NodeBases { float node_bases[]; };
// Where each part's Gaussians begin, PARTS + 1 words; where its nodes begin in the list that
// follows, PARTS + 1 words; the list.
layout(std430, set = 0, binding = 6) readonly buffer Members { uint members[]; };
layout(std430, set = 0, binding = 7) writeonly buffer OfSums { float of_sums[]; };
#include "train/features.glsl"
#include "train/gradient.glsl"
#include "train/corrective.glsl"

const uint ROWS = TRAIN_FEATURES_WORKGROUP / TRAIN_BASIS;
shared float sums[2u * TRAIN_FEATURES_WORKGROUP];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint part = gl_WorkGroupID.x;
    uint view = gl_WorkGroupID.y;
    uint k = thread % TRAIN_BASIS;
    uint row = thread / TRAIN_BASIS;
    float attributes = 0.0;
    for (uint g = members[part] + row; g < members[part + 1u]; g += ROWS) {
        uint at = gradient_at(view, g);
        uvec3 own = rows[g].xyz;
        uint signs = floatBitsToUint(of_gaussians[at + 2u].w);
        if (own.x != TRAIN_NO_ROW) {
            vec4 of = of_rotation(of_gaussians[at], signs);
            uint basis = 4u * TRAIN_BASIS * own.x + k;
            for (uint c = 0u; c < 4u; ++c) {
                attributes += of[c] * bases[basis + c * TRAIN_BASIS];
            }
        }
        if (own.y != TRAIN_NO_ROW) {
            vec3 of = of_scale(of_gaussians[at + 1u].xyz, signs);
            uint basis = block.network.z + 3u * TRAIN_BASIS * own.y + k;
            for (uint c = 0u; c < 3u; ++c) {
                attributes += of[c] * bases[basis + c * TRAIN_BASIS];
            }
        }
        if (own.z != TRAIN_NO_ROW) {
            vec3 of = of_color(of_gaussians[at + 2u].xyz, signs);
            uint basis = block.network.w + 3u * TRAIN_BASIS * own.z + k;
            for (uint c = 0u; c < 3u; ++c) {
                attributes += of[c] * bases[basis + c * TRAIN_BASIS];
            }
        }
    }
    float positions = 0.0;
    uint lists = PARTS + 1u;
    for (uint at = members[lists + part] + row; at < members[lists + part + 1u]; at += ROWS) {
        uint node = members[2u * lists + at];
        vec3 of = of_nodes[view * NODES + node].xyz;
        uint basis = 3u * TRAIN_BASIS * node + k;
        for (uint c = 0u; c < 3u; ++c) {
            positions += of[c] * node_bases[basis + c * TRAIN_BASIS];
        }
    }
    sums[thread] = attributes;
    sums[TRAIN_FEATURES_WORKGROUP + thread] = positions;
    barrier();
    if (thread < 2u * TRAIN_BASIS) {
        uint first = thread / TRAIN_BASIS * TRAIN_FEATURES_WORKGROUP + k;
        float sum = 0.0;
        for (uint r = 0u; r < ROWS; ++r) {
            sum += sums[first + r * TRAIN_BASIS];
        }
        of_sums[features_at(view, part) + thread] = sum;
    }
}
