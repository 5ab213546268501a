// The derivative of stage project: from that of a splat, summed over its pairs in their order, to
// that of a Gaussian's attributes. reference::project::project_backward and pose_backward have the
// mathematics.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Fixed { uvec4 fixed_words[]; };
layout(std430, set = 0, binding = 2) readonly buffer Joints { vec4 joints[]; };
layout(std430, set = 0, binding = 3) readonly buffer Canonical { vec4 canonical[]; };
// Of each Gaussian: its first pair, and how many it has.
layout(std430, set = 0, binding = 4) readonly buffer SplatPairs { uvec2 splat_pairs[]; };
// Of each pair: colour, opacity, centre, Σ⁻¹.
layout(std430, set = 0, binding = 5) readonly buffer Records { float records[]; };
layout(std430, set = 0, binding = 6) writeonly buffer OfGaussians { vec4 of_gaussians[]; };
// Of this view's skinning transforms, three rows each, where they are asked for.
layout(std430, set = 0, binding = 7) writeonly buffer OfSkinning { vec4 of_skinning[]; };
// Of each Gaussian, where a view has several bands: sums over pairs, and 1 where there are any.
layout(std430, set = 0, binding = 8) buffer OfSplats { float of_splats[]; };
#include "train/gradient.glsl"
#include "train/gaussian.glsl"

void main() {
    uint g = gl_GlobalInvocationID.x;
    if (g >= GAUSSIANS) {
        return;
    }
    uvec2 pairs = splat_pairs[g];
    float of[TRAIN_RECORD];
    uint sums = (TRAIN_RECORD + 1u) * g;
    bool is_first = block.band.z != 0u;
    for (uint c = 0u; c < TRAIN_RECORD; ++c) {
        of[c] = is_first ? 0.0 : of_splats[sums + c];
    }
    for (uint pair = pairs.x; pair < pairs.x + pairs.y; ++pair) {
        for (uint c = 0u; c < TRAIN_RECORD; ++c) {
            of[c] += records[TRAIN_RECORD * pair + c];
        }
    }
    bool is_seen = pairs.y > 0u || (!is_first && of_splats[sums + TRAIN_RECORD] > 0.0);
    if (block.band.w == 0u) {
        // Another band adds to it.
        for (uint c = 0u; c < TRAIN_RECORD; ++c) {
            of_splats[sums + c] = of[c];
        }
        of_splats[sums + TRAIN_RECORD] = float(is_seen);
        return;
    }
    uint at = gradient_at(VIEW, g);
    vec4 rotation = canonical[4u * g];
    vec4 scale_opacity = canonical[4u * g + 1u];
    vec4 color_signs = canonical[4u * g + 2u];
    vec4 position = vec4(canonical[4u * g + 3u].xyz, 1.0);
    // What makes Gaussians small, whether they are seen or not (loss `scale`).
    vec3 s = exp(min(scale_opacity.xyz, vec3(LOG_SCALE_MAX)));
    vec3 of_log_scale = vec3(0.0);
    for (uint k = 0u; k < 3u; ++k) {
        of_log_scale[k] = s[k] > block.loss_weights.z ? block.loss_weights.y * s[k] : 0.0;
    }
    if (!is_seen) {
        of_gaussians[at] = vec4(0.0);
        of_gaussians[at + 1u] = vec4(of_log_scale, 0.0);
        of_gaussians[at + 2u] = vec4(vec3(0.0), color_signs.w);
        of_gaussians[at + 3u] = vec4(0.0);
        if (ASKS_JOINTS) {
            for (uint row = 0u; row < 3u; ++row) {
                of_skinning[3u * g + row] = vec4(0.0);
            }
        }
        return;
    }
    vec2 of_center = vec2(of[4], of[5]);

    // Forward again, as far as it is needed.
    vec4 q = rotation == vec4(0.0) ? vec4(1.0, 0.0, 0.0, 0.0) : normalize(rotation);
    Placed placed = placed_at(g);
    vec4 row_x, row_y, row_z;
    skin(VIEW, placed, row_x, row_y, row_z);
    mat3 g3 = transpose(mat3(row_x.xyz, row_y.xyz, row_z.xyz));
    mat3 turned = rotation_matrix(q);
    mat3 local = turned;
    local[0] *= s.x;
    local[1] *= s.y;
    local[2] *= s.z;
    mat3 view = view_matrix();
    mat3 m = view * (g3 * local);
    vec3 mean = vec3(dot(row_x, position), dot(row_y, position), dot(row_z, position));
    vec3 t = view * mean + view_offset();
    vec2 f = block.lens.xy / t.z;
    vec2 ratio = t.xy / t.z;
    vec2 slope = clamp(ratio, block.slopes.xy, block.slopes.zw);
    vec3 derivative_x = vec3(f.x, 0.0, -f.x * slope.x);
    vec3 derivative_y = vec3(0.0, f.y, -f.y * slope.y);
    Footprint footprint = view_footprint(t, view * g3, local);
    vec3 across = footprint.across;
    vec3 down = footprint.down;
    float a = footprint.covariance.x;
    float b = footprint.covariance.y;
    float c = footprint.covariance.z;
    float unfiltered = footprint.unfiltered;
    float det = footprint.determinant;
    float opacity = 1.0 / (1.0 + exp(-scale_opacity.w));
    bool compensated = block.low_pass.y > 0.0;
    // How far it fades, as it moves, is left out: see reference::project::project_backward.
    float fade = view_fade(placed, view * g3, t);
    float factor = fade * (compensated ? sqrt(unfiltered / det) : 1.0);

    // Σ⁻¹ to Σ.
    mat2 inverse = mat2(c, -b, -b, a) * (1.0 / det);
    mat2 of_covariance = -(inverse * mat2(of[6], 0.5 * of[7], 0.5 * of[7], of[8]) * inverse);
    float of_a = of_covariance[0][0];
    float of_b = 2.0 * of_covariance[0][1];
    float of_c = of_covariance[1][1];
    vec3 of_across = vec3(0.0), of_down = vec3(0.0);
    if (compensated && unfiltered > 0.0) {
        float of_log = 0.5 * of[3] * opacity * factor;
        float scale = 2.0 * of_log / unfiltered;
        float across_down = dot(across, down);
        of_across += scale * (dot(down, down) * across - across_down * down);
        of_down += scale * (dot(across, across) * down - across_down * across);
        of_a -= of_log * c / det;
        of_c -= of_log * a / det;
        of_b += 2.0 * of_log * b / det;
    }
    of_across += 2.0 * of_a * across + of_b * down;
    of_down += 2.0 * of_c * down + of_b * across;
    mat3 of_m = outerProduct(derivative_x, of_across) + outerProduct(derivative_y, of_down);
    vec3 of_derivative_x = m * of_across;
    vec3 of_derivative_y = m * of_down;
    vec3 of_t = vec3(0.0);
    vec2 of_f = vec2(of_derivative_x.x - slope.x * of_derivative_x.z,
                     of_derivative_y.y - slope.y * of_derivative_y.z);
    of_t.z -= dot(of_f, f) / t.z;
    vec2 of_slope = vec2(slope.x == ratio.x ? -f.x * of_derivative_x.z : 0.0,
                         slope.y == ratio.y ? -f.y * of_derivative_y.z : 0.0);
    of_t.xy += of_slope / t.z + f * of_center;
    of_t.z -= dot(of_slope, slope) / t.z + dot(f * ratio, of_center);
    vec3 of_mean = transpose(view) * of_t;
    mat3 of_axes = transpose(view) * of_m;

    // To the attributes.
    mat3 of_local = transpose(g3) * of_axes;
    for (uint k = 0u; k < 3u; ++k) {
        if (scale_opacity[k] < LOG_SCALE_MAX) {
            of_log_scale[k] += dot(local[k], of_local[k]);
        }
    }
    mat3 r = of_local;
    r[0] *= s.x;
    r[1] *= s.y;
    r[2] *= s.z;
    // Row i and column j of a matrix of columns is r[j][i].
    float skew_x = r[1][2] - r[2][1];
    float skew_y = r[2][0] - r[0][2];
    float skew_z = r[0][1] - r[1][0];
    float xy = r[0][1] + r[1][0];
    float xz = r[0][2] + r[2][0];
    float yz = r[1][2] + r[2][1];
    vec4 of_q = 2.0 * vec4(
        q.y * skew_x + q.z * skew_y + q.w * skew_z,
        q.x * skew_x - 2.0 * q.y * (r[1][1] + r[2][2]) + q.z * xy + q.w * xz,
        q.x * skew_y + q.y * xy - 2.0 * q.z * (r[0][0] + r[2][2]) + q.w * yz,
        q.x * skew_z + q.y * xz + q.z * yz - 2.0 * q.w * (r[0][0] + r[1][1]));
    vec4 of_rotation = rotation == vec4(0.0) ? vec4(0.0) : (of_q - dot(of_q, q) * q) / length(rotation);
    vec3 of_color = vec3(of[0], of[1], of[2]);
    for (uint k = 0u; k < 3u; ++k) {
        if (!(color_signs[k] >= 0.0 && color_signs[k] <= 1.0)) {
            of_color[k] = 0.0;
        }
    }
    of_gaussians[at] = of_rotation;
    of_gaussians[at + 1u] = vec4(of_log_scale, of[3] * factor * opacity * (1.0 - opacity));
    of_gaussians[at + 2u] = vec4(of_color, color_signs.w);
    of_gaussians[at + 3u] = vec4(transpose(g3) * of_mean, 0.0);
    if (ASKS_JOINTS) {
        mat3 of_linear = of_axes * transpose(local) + outerProduct(of_mean, position.xyz);
        for (uint row = 0u; row < 3u; ++row) {
            of_skinning[3u * g + row] =
                vec4(of_linear[0][row], of_linear[1][row], of_linear[2][row], of_mean[row]);
        }
    }
}
