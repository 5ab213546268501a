// Stage project of the training (model.md, steps 2 and 4 to 8): each Gaussian with its correctives,
// posed, as an ellipse in the image; culled as in shaders/project.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Learned { vec4 learned[]; };
layout(std430, set = 0, binding = 2) readonly buffer Fixed { uvec4 fixed_words[]; };
layout(std430, set = 0, binding = 3) readonly buffer Bases { float bases[]; };
layout(std430, set = 0, binding = 4) readonly buffer Rows { uvec4 rows[]; };
layout(std430, set = 0, binding = 5) readonly buffer Activations { float activations[]; };
// Of all views: joints, three rows each.
layout(std430, set = 0, binding = 6) readonly buffer Joints { vec4 joints[]; };
layout(std430, set = 0, binding = 7) readonly buffer Displaced { vec4 displaced[]; };
// For the way back, four vectors each, like train/gradient.glsl: the attributes with correctives.
layout(std430, set = 0, binding = 8) writeonly buffer Canonical { vec4 canonical[]; };
// Three vectors a splat: centre and half the sides of its box, px; Σ⁻¹ and opacity; colour and
// depth.
layout(std430, set = 0, binding = 9) writeonly buffer Splats { vec4 splats[]; };
layout(std430, set = 0, binding = 10) writeonly buffer Keys { uint keys[]; };
layout(std430, set = 0, binding = 11) writeonly buffer SplatPairs { uvec2 splat_pairs[]; };
#include "train/features.glsl"
#include "train/gradient.glsl"
#include "train/gaussian.glsl"

void write_culled(uint g) {
    keys[g] = SORT_CULLED;
}

void main() {
    uint g = gl_GlobalInvocationID.x;
    if (g >= GAUSSIANS) {
        return;
    }
    // Who is drawn gets pairs later.
    splat_pairs[g] = uvec2(0u);
    Placed placed = placed_at(g);
    vec4 rotation = learned[3u * g];
    vec4 scale_opacity = learned[3u * g + 1u];
    vec3 log_scale = scale_opacity.xyz;
    vec3 color = learned[3u * g + 2u].xyz;
    uint signs = 0u;
    vec4 neutral = rotation;
    if (HAS_CORRECTIVES) {
        uint features = features_at(VIEW, placed.part);
        uvec3 own = rows[g].xyz;
        if (own.x != TRAIN_NO_ROW) {
            for (uint c = 0u; c < 4u; ++c) {
                uint basis = TRAIN_BASIS * (4u * own.x + c);
                float sum = 0.0;
                for (uint k = 0u; k < TRAIN_BASIS; ++k) {
                    sum += bases[basis + k] * activations[features + k];
                }
                rotation[c] += sum;
                signs |= sign_bits(sum, c);
            }
        }
        if (own.y != TRAIN_NO_ROW) {
            for (uint c = 0u; c < 3u; ++c) {
                uint basis = block.network.z + TRAIN_BASIS * (3u * own.y + c);
                float sum = 0.0;
                for (uint k = 0u; k < TRAIN_BASIS; ++k) {
                    sum += bases[basis + k] * activations[features + k];
                }
                log_scale[c] += sum;
                signs |= sign_bits(sum, 4u + c);
            }
        }
        if (own.z != TRAIN_NO_ROW) {
            for (uint c = 0u; c < 3u; ++c) {
                uint basis = block.network.w + TRAIN_BASIS * (3u * own.z + c);
                float sum = 0.0;
                for (uint k = 0u; k < TRAIN_BASIS; ++k) {
                    sum += bases[basis + k] * activations[features + k];
                }
                color[c] += sum;
                signs |= sign_bits(sum, 7u + c);
            }
        }
    }
    vec3 position = placed.position;
    for (uint n = 0u; n < 3u; ++n) {
        position += placed.node_weight[n] * displaced[VIEW * NODES + placed.node[n]].xyz;
    }
    if (dot(rotation, rotation) < ROTATION_MIN * ROTATION_MIN * dot(neutral, neutral)) {
        // No derivative of the rotation follows from a quaternion of zeros.
        rotation = vec4(0.0);
    }
    uint at = 4u * g;
    canonical[at] = rotation;
    canonical[at + 1u] = vec4(log_scale, scale_opacity.w);
    canonical[at + 2u] = vec4(color, uintBitsToFloat(signs));
    canonical[at + 3u] = vec4(position, 0.0);
    if (rotation == vec4(0.0)) {
        rotation = neutral;
    }

    vec4 row_x, row_y, row_z;
    skin(VIEW, placed, row_x, row_y, row_z);
    vec4 x = vec4(position, 1.0);
    vec3 mean = vec3(dot(row_x, x), dot(row_y, x), dot(row_z, x));
    mat3 g3 = transpose(mat3(row_x.xyz, row_y.xyz, row_z.xyz));
    vec3 s = exp(min(log_scale, vec3(LOG_SCALE_MAX)));
    mat3 local = rotation_matrix(normalize(rotation));
    local[0] *= s.x;
    local[1] *= s.y;
    local[2] *= s.z;
    vec3 t = view_matrix() * mean + view_offset();
    float opacity = 1.0 / (1.0 + exp(-scale_opacity.w));
    float fade = view_fade(placed, view_matrix() * g3, t);
    // Compared so that NaN fails.
    if (!(t.z >= block.near.x && opacity * 255.0 > 1.0 && fade > 0.0)) {
        write_culled(g);
        return;
    }
    Footprint footprint = view_footprint(t, view_matrix() * g3, local);
    vec3 covariance = footprint.covariance;
    vec2 center = block.lens.xy * t.xy / t.z + block.lens.zw;
    vec2 size = vec2(block.image_size.xy);
    if (!is_drawable(footprint) || !all(lessThanEqual(abs(color), vec3(FEATURE_MAX)))) {
        write_culled(g);
        return;
    }
    if (block.low_pass.y > 0.0) {
        opacity *= sqrt(footprint.unfiltered / footprint.determinant);
    }
    opacity *= fade;
    float reach = 2.0 * log(255.0 * opacity);
    if (!(reach >= 0.0)) {
        write_culled(g);
        return;
    }
    vec2 radius = sqrt(reach * covariance.xz);
    if (!(all(greaterThanEqual(center + radius, vec2(0.0))) &&
          all(greaterThanEqual(size + radius - center, vec2(0.0))))) {
        write_culled(g);
        return;
    }
    keys[g] = floatBitsToUint(t.z);
    splats[3u * g] = vec4(center, radius);
    splats[3u * g + 1u] = vec4(vec3(covariance.z, -covariance.y, covariance.x) / footprint.determinant, opacity);
    splats[3u * g + 2u] = vec4(clamp(color, 0.0, 1.0), t.z);
}
