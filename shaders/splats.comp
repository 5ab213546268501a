// Everything that happens to one Gaussian (model.md, steps 2 and 4 to 8): sparse correctives, node interpolation, skinning,
// covariance, projection, culling, depth key. A 16-byte splat and a key come out. With KEEP also what no camera changes, for
// `splats_posed`, of all Gaussians that are drawn, seen or not.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "layout.glsl"
#include "splat.glsl"
#include "depth.glsl"
#include "gaussian.glsl"
#include "posed.glsl"

// For what skinning and correctives add to a Gaussian's length.
#define LONGEST_ROOM 1.2

layout(local_size_x = SPLATS_SIZE) in;
#ifndef KEEP
layout(constant_id = 0) const bool KEEP = false;
#endif
layout(std430, set = 0, binding = 1) readonly buffer Gaussians { uvec2 gaussians[]; };
// A row: a word with the worth of a step (f16) and the part; for colours two with the neutral colour, three f16; then components, four
// basis functions a word.
layout(std430, set = 0, binding = 2) readonly buffer Rows { uint rows[]; };
layout(std430, set = 0, binding = 3) readonly buffer PoseBuffer { uvec2 posed[]; };
layout(std430, set = 0, binding = 4) buffer Splats { uint words[]; };
#include "project.glsl"

uint feature_of(uint head) { return frame.feature_start + (head >> 16u) * frame.feature_quads; }

// What unpackSnorm4x8 makes 1 of is 127 steps.
float worth_of(uint head) { return 127.0 * unpackHalf2x16(head).x; }

// What rows next to each other make of their part's features.
vec3 row_dot3(uint head, uint at) {
    uint feature = feature_of(head), quads = frame.basis_quads;
    vec3 sum = vec3(0.0);
    uint b = 0u;
    do {
        vec4 features = features_of(feature + b);
        sum += vec3(dot(unpackSnorm4x8(rows[at + b]), features), dot(unpackSnorm4x8(rows[at + quads + b]), features),
                    dot(unpackSnorm4x8(rows[at + 2u * quads + b]), features));
    } while (++b < quads);
    return worth_of(head) * sum;
}

vec4 row_dot4(uint head, uint at) {
    uint feature = feature_of(head), quads = frame.basis_quads;
    vec4 sum = vec4(0.0);
    uint b = 0u;
    do {
        vec4 features = features_of(feature + b);
        sum += vec4(dot(unpackSnorm4x8(rows[at + b]), features), dot(unpackSnorm4x8(rows[at + quads + b]), features),
                    dot(unpackSnorm4x8(rows[at + 2u * quads + b]), features), dot(unpackSnorm4x8(rows[at + 3u * quads + b]), features));
    } while (++b < quads);
    return worth_of(head) * sum;
}

// Columns of the rotation matrix of a unit quaternion w x y z, here held as (w, x, y, z) in (x, y, z, w) of the vector.
mat3 rotation_matrix(vec4 q) {
    float w = q.x, x = q.y, y = q.z, z = q.w;
    return mat3(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y),
                2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x),
                2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y));
}

// Whether all parts that the Gaussians around this one are of lie outside the view.
bool outside(uint block) {
    uint parts = gaussians[block + 3u].x, part = parts & 0xffffu;
    bool all_outside = true;
    do {
        all_outside = (frame.outside[part >> 7u][part >> 5u & 3u] >> (part & 31u) & 1u) != 0u;
        ++part;
    } while (all_outside && part <= parts >> 16u);
    return all_outside;
}

// Steps 2 and 5: the correctives of the rows that were kept.
void correct(uint i, uint block, inout vec4 rotation, inout vec3 log_scale, inout vec3 color) {
    uint bit = 1u << (i & 31u);
    uvec2 first = gaussians[block], second = gaussians[block + 1u], third = gaussians[block + 2u];
    if ((first.x & bit) != 0u) {
        uint at = frame.rotation_start + (second.y + bitCount(first.x & (bit - 1u))) * (1u + 4u * frame.basis_quads);
        vec4 corrected = rotation + row_dot4(rows[at], at + 1u);
        // What is left of the neutral quaternion, of length 1, may be too short to have a direction.
        rotation = length(corrected) >= ROTATION_MIN ? corrected : rotation;
    }
    if ((first.y & bit) != 0u) {
        uint at = frame.scale_start + (third.x + bitCount(first.y & (bit - 1u))) * (1u + 3u * frame.basis_quads);
        log_scale += row_dot3(rows[at], at + 1u);
    }
    if ((second.x & bit) != 0u) {
        uint at = frame.color_start + (third.y + bitCount(second.x & (bit - 1u))) * (3u + 3u * frame.basis_quads);
        vec3 neutral = vec3(unpackHalf2x16(rows[at + 1u]), unpackHalf2x16(rows[at + 2u]).x);
        color = (frame.lit_start > 0u ? color : neutral) + row_dot3(rows[at], at + 3u);
    }
}

// Written out: what is named by a variable is looked for in each invocation.
#define JOINT(k) \
    { \
        uint at = 3u * joint.k; \
        r0 += joint_weight.k * frame.joint[at]; \
        r1 += joint_weight.k * frame.joint[at + 1u]; \
        r2 += joint_weight.k * frame.joint[at + 2u]; \
    }

// The splat at `slot` of the avatar's own; gives its key.
uint splat_of(uint slot) {
    uint n = frame.gaussians;
    uint i = slot << frame.level;
    uint block = GAUSSIAN_PAIRS * n + BLOCK_PAIRS * (i >> 5u);
    if (!KEEP && outside(block)) {
        left_out(OUTSIDE);
        return SORT_DROPPED;
    }
    uvec2 place = gaussians[2u * i], skin = gaussians[2u * i + 1u], near = gaussians[2u * n + i];
    vec3 weight = gaussian_node_weights(near);
    uvec3 node = gaussian_nodes(near);
    vec4 x = vec4(gaussian_position(place) + weight.x * displacement_of(node.x) + weight.y * displacement_of(node.y) +
                      weight.z * displacement_of(node.z), 1.0);
    vec3 log_scale = gaussian_log_scale(place, skin, near);

    // Step 6, with the view folded into the joints: rows of the 3 by 4 matrix from canonical space to the camera.
    uvec4 joint = gaussian_joints(skin);
    vec4 joint_weight = gaussian_weights(skin);
    vec4 r0 = vec4(0.0), r1 = vec4(0.0), r2 = vec4(0.0);
    JOINT(x) JOINT(y) JOINT(z) JOINT(w)
    vec3 p = vec3(dot(r0, x), dot(r1, x), dot(r2, x));
    mat3 turned = mat3(r0.xyz, r1.xyz, r2.xyz);
    float longest = LONGEST_ROOM * exp(min(max(max(log_scale.x, log_scale.y), log_scale.z), float(LOG_SCALE_MAX))) *
                    sqrt(max(max(dot(r0.xyz, r0.xyz), dot(r1.xyz, r1.xyz)), dot(r2.xyz, r2.xyz)));
    vec2 center;
    float key;
    bool seen = lands(p, longest, center, key);
    if (!KEEP && !seen) {
        return SORT_DROPPED;
    }
    uvec2 look = gaussians[3u * n + i];
    uint opacity = look.y >> 24u;
    if (!KEEP && float(opacity) <= frame.cutoff) {
        left_out(FAINT);
        return SORT_DROPPED;
    }
    vec4 rotation = gaussian_rotation(look.x);
    vec3 color = unpackUnorm4x8(look.y).rgb;
    if (frame.lit_start > 0u) {
        uvec2 lit = gaussians[frame.lit_start + i];
        color = vec3(unpackHalf2x16(lit.x), unpackHalf2x16(lit.y).x);
    }
    correct(i, block, rotation, log_scale, color);

    // Step 7.
    mat3 axes = rotation_matrix(normalize(rotation));
    vec3 scale = exp(min(log_scale, float(LOG_SCALE_MAX)));
    axes = mat3(axes[0] * scale.x, axes[1] * scale.y, axes[2] * scale.z);
    if (KEEP) {
        mat3 m = transpose(turned) * axes;
        uint at = frame.posed_start + 2u * slot;
        uvec2 first = posed_place(p, longest, m, opacity);
        uvec3 rest = posed_shape(m, first, clamp(color, 0.0, 1.0));
        words[at] = first.x;
        words[at + 1u] = first.y;
        at = frame.posed_start + 2u * n + 3u * slot;
        words[at] = rest.x;
        words[at + 1u] = rest.y;
        words[at + 2u] = rest.z;
        if (seen && float(opacity) <= frame.cutoff) {
            left_out(FAINT);
        }
        if (!seen || float(opacity) <= frame.cutoff) {
            return SORT_DROPPED;
        }
    }
    return draw(slot, p, center, key, turned, axes, color, opacity);
}

void main() {
    uint slot = gl_GlobalInvocationID.x;
    write_key(slot, slot < frame.drawn ? splat_of(slot) : SORT_DROPPED);
}
