// From a Gaussian to a splat and its key (model.md, steps 2 and 4 to 8): sparse correctives, node
// interpolation, skinning, facing, covariance, projection, culling, depth key. With STORE it also
// writes the pose cache for `project_cached`, of all Gaussians that are drawn, visible or not.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"
#include "common/frame.glsl"
#include "common/opaque.glsl"
#include "common/splat.glsl"
#include "common/depth_key.glsl"
#include "common/gaussian.glsl"
#include "project/facing.glsl"
#include "project/pose_cache.glsl"

layout(local_size_x = PROJECT_WORKGROUP) in;
PARAMETER(0, bool, STORE, false)
layout(std430, set = 0, binding = 1) readonly buffer Gaussians { uvec2 gaussians[]; };
// A basis row: a word with the size of a step (f16) and the part; for colours two words with the
// neutral colour, three f16; then components, four basis functions a word.
layout(std430, set = 0, binding = 2) readonly buffer Rows { uint rows[]; };
layout(std430, set = 0, binding = 3) readonly buffer PoseBuffer { uvec2 pose[]; };
layout(std430, set = 0, binding = 4) buffer Splats { uint words[]; };
#include "common/pose.glsl"
#include "project/projection.glsl"
#include "common/rotation.glsl"

uint feature_of(uint head) { return frame.feature_start + (head >> 16u) * frame.feature_quads; }

// Scale of what unpackSnorm4x8 gives: 1 for 127 steps.
float scale_of(uint head) { return 127.0 * unpackHalf2x16(head).x; }

// Products of three or four neighbouring basis rows with their part's features.
vec3 row_dot3(uint head, uint at) {
    uint feature = feature_of(head), quads = opaque_end(frame.basis_quads, head);
    vec3 sum = vec3(0.0);
    uint b = 0u;
    do {
        vec4 features = features_of(feature + b);
        sum += vec3(dot(unpackSnorm4x8(rows[at + b]), features),
                    dot(unpackSnorm4x8(rows[at + quads + b]), features),
                    dot(unpackSnorm4x8(rows[at + 2u * quads + b]), features));
    } while (++b < quads);
    return scale_of(head) * sum;
}

vec4 row_dot4(uint head, uint at) {
    uint feature = feature_of(head), quads = opaque_end(frame.basis_quads, head);
    vec4 sum = vec4(0.0);
    uint b = 0u;
    do {
        vec4 features = features_of(feature + b);
        sum += vec4(dot(unpackSnorm4x8(rows[at + b]), features),
                    dot(unpackSnorm4x8(rows[at + quads + b]), features),
                    dot(unpackSnorm4x8(rows[at + 2u * quads + b]), features),
                    dot(unpackSnorm4x8(rows[at + 3u * quads + b]), features));
    } while (++b < quads);
    return scale_of(head) * sum;
}

// Whether all parts of the 32 Gaussians of a block lie outside the view.
bool outside_view(uint block) {
    uint parts = gaussians[block + 3u].x;
    bool all_outside = true;
    for (uint part = parts & 0xffffu; all_outside && part <= parts >> 16u; ++part) {
        all_outside =
            (frame.culled_parts[part >> 7u][part >> 5u & 3u] >> (part & 31u) & 1u) != 0u;
    }
    return all_outside;
}

// Steps 2 and 5: adds the correctives of the basis rows that the Gaussian has.
void correct(uint i, uint block, inout vec4 rotation, inout vec3 log_scale, inout vec3 color) {
    uint bit = 1u << (i & 31u);
    uvec2 first = gaussians[block], second = gaussians[block + 1u], third = gaussians[block + 2u];
    if ((first.x & bit) != 0u) {
        uint row = second.y + bitCount(first.x & (bit - 1u));
        uint at = frame.rotation_start + row * (1u + 4u * frame.basis_quads);
        vec4 corrected = rotation + row_dot4(rows[at], at + 1u);
        // A corrective may cancel the neutral quaternion: too short, it has no usable direction.
        rotation = length(corrected) >= ROTATION_MIN ? corrected : rotation;
    }
    if ((first.y & bit) != 0u) {
        uint row = third.x + bitCount(first.y & (bit - 1u));
        uint at = frame.scale_start + row * (1u + 3u * frame.basis_quads);
        log_scale += row_dot3(rows[at], at + 1u);
    }
    if ((second.x & bit) != 0u) {
        uint row = third.y + bitCount(second.x & (bit - 1u));
        uint at = frame.color_start + row * (3u + 3u * frame.basis_quads);
        vec3 neutral = vec3(unpackHalf2x16(rows[at + 1u]), unpackHalf2x16(rows[at + 2u]).x);
        color = (frame.sh_color_start > 0u ? color : neutral) + row_dot3(rows[at], at + 3u);
    }
}

// Adds a joint's weighted matrix to rows of a Gaussian's.
void add_joint(uint joint, float weight, inout vec4 r0, inout vec4 r1, inout vec4 r2) {
    uint at = 3u * joint;
    r0 += weight * frame.joint[at];
    r1 += weight * frame.joint[at + 1u];
    r2 += weight * frame.joint[at + 2u];
}

// Writes the splat at `index` of the avatar's own; gives its key.
uint project_gaussian(uint index) {
    uint n = frame.gaussians;
    uint i = index << frame.detail_level;
    uint block = GAUSSIAN_PAIRS * n + BLOCK_PAIRS * (i >> 5u);
    if (!STORE && outside_view(block)) {
        count_culled(OUTSIDE);
        return SORT_CULLED;
    }
    uvec2 position = gaussians[2u * i], skin = gaussians[2u * i + 1u], near = gaussians[2u * n + i];
    vec3 weight = gaussian_node_weights(near);
    uvec3 node = gaussian_nodes(near);
    vec4 x = vec4(gaussian_position(position) + weight.x * displacement_of(node.x) +
                      weight.y * displacement_of(node.y) + weight.z * displacement_of(node.z), 1.0);
    vec3 log_scale = gaussian_log_scale(position, skin, near);

    // Step 6. The joints' matrices include the view: r0, r1 and r2 are the rows of the 3 by 4
    // matrix from canonical space to the camera. A loop would index `joint` by a variable, which
    // CPU drivers do invocation by invocation.
    uvec4 joint = gaussian_joints(skin);
    vec4 joint_weight = gaussian_weights(skin);
    vec4 r0 = vec4(0.0), r1 = vec4(0.0), r2 = vec4(0.0);
    add_joint(joint.x, joint_weight.x, r0, r1, r2);
    add_joint(joint.y, joint_weight.y, r0, r1, r2);
    add_joint(joint.z, joint_weight.z, r0, r1, r2);
    add_joint(joint.w, joint_weight.w, r0, r1, r2);
    vec3 p = vec3(dot(r0, x), dot(r1, x), dot(r2, x));
    mat3 linear = mat3(r0.xyz, r1.xyz, r2.xyz);
    vec2 center;
    float key;
    bool visible = project_center(p, center, key);
    float fade = 1.0;
    if (frame.facing_start > i) {
        uvec2 pair = gaussians[frame.facing_start + (i >> 1u)];
        uint facing = (i & 1u) == 0u ? pair.x : pair.y;
        vec3 axis = facing_axis(facing) * linear;
        uint limit = facing_limit_code(facing);
        fade = facing_fade(axis, limit, p);
        if (STORE) {
            words[cached_facing_at(index)] = cache_facing(axis, limit);
        }
        if (visible && fade <= 0.0) {
            count_culled(AWAY);
            visible = false;
        }
    }
    // By how much a corrective makes one larger is not known yet.
    bool corrected = (gaussians[block].y >> (i & 31u) & 1u) != 0u;
    if (visible && !corrected) {
        float largest = max(max(log_scale.x, log_scale.y), log_scale.z);
        visible = !misses_area(p, center, linear, exp(min(largest, LOG_SCALE_MAX)));
    }
    if (!STORE && !visible) {
        return SORT_CULLED;
    }
    uvec2 appearance = gaussians[3u * n + i];
    uint opacity = appearance.y >> 24u;
    if (!STORE && float(opacity) <= frame.cutoff) {
        count_culled(FAINT);
        return SORT_CULLED;
    }
    vec4 rotation = gaussian_rotation(appearance.x);
    vec3 color = unpackUnorm4x8(appearance.y).rgb;
    // The colours' plane begins behind all others, if there is one.
    if (frame.sh_color_start > i) {
        uvec2 sh_color = gaussians[frame.sh_color_start + i];
        color = vec3(unpackHalf2x16(sh_color.x), unpackHalf2x16(sh_color.y).x);
    }
    correct(i, block, rotation, log_scale, color);

    // Step 7.
    mat3 axes = rotation_matrix(normalize(rotation));
    vec3 scale = exp(min(log_scale, LOG_SCALE_MAX));
    axes = mat3(axes[0] * scale.x, axes[1] * scale.y, axes[2] * scale.z);
    if (STORE) {
        mat3 m = transpose(linear) * axes;
        uint at = frame.cache_start + 3u * index;
        uvec3 first = cache_position(p, m, opacity);
        uvec3 rest = cache_shape(m, first, clamp(color, 0.0, 1.0));
        words[at] = first.x;
        words[at + 1u] = first.y;
        words[at + 2u] = first.z;
        at = frame.cache_start + 3u * (frame.drawn + index);
        words[at] = rest.x;
        words[at + 1u] = rest.y;
        words[at + 2u] = rest.z;
        if (visible && float(opacity) <= frame.cutoff) {
            count_culled(FAINT);
        }
        if (!visible || float(opacity) <= frame.cutoff) {
            return SORT_CULLED;
        }
    }
    return write_splat(index, p, center, key, linear, axes, color, opacity, fade);
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index < frame.drawn) {
        write_key(index, project_gaussian(index));
    }
}
