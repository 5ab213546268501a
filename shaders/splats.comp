// Everything that happens to one Gaussian (model.md, steps 2 and 4 to 8): sparse correctives, node interpolation, skinning,
// covariance, projection, culling, depth key. A 16-byte splat and a key come out; nothing in world space is written.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "half.glsl"
#include "layout.glsl"
#include "splat.glsl"
#include "depth.glsl"

layout(local_size_x = SPLATS_SIZE) in;
// GAUSSIAN_PLANES planes of one vector a Gaussian, then two vectors for every 32 Gaussians: which of them keep a row of rotation,
// scale and colour (a bit each), and how many rows come before.
layout(std430, set = 0, binding = 1) readonly buffer Gaussians { uvec4 gaussians[]; };
layout(std430, set = 0, binding = 2) readonly buffer Rows { HALF_QUAD rows[]; };
layout(std430, set = 0, binding = 3) readonly buffer PoseBuffer { vec4 posed[]; };
// Four words a Gaussian of the scene, then, from the next multiple of 64 words on, a key a Gaussian, then what left_out.glsl counts.
layout(std430, set = 0, binding = 4) buffer Splats { uint words[]; };
#include "left_out.glsl"

float row_dot(uint row, uint feature) {
    float sum = 0.0;
    for (uint b = 0u; b < frame.basis_quads; ++b) {
        sum += dot(widen(rows[row + b]), posed[feature + b]);
    }
    return sum;
}

vec3 row_dot3(uint start, uint row, uint feature) {
    uint at = start + row * 3u * frame.basis_quads;
    return vec3(row_dot(at, feature), row_dot(at + frame.basis_quads, feature), row_dot(at + 2u * frame.basis_quads, feature));
}

vec4 row_dot4(uint start, uint row, uint feature) {
    uint at = start + row * 4u * frame.basis_quads;
    return vec4(row_dot(at, feature), row_dot(at + frame.basis_quads, feature), row_dot(at + 2u * frame.basis_quads, feature),
                row_dot(at + 3u * frame.basis_quads, feature));
}

// Columns of the rotation matrix of a unit quaternion w x y z, here held as (w, x, y, z) in (x, y, z, w) of the vector.
mat3 rotation_matrix(vec4 q) {
    float w = q.x, x = q.y, y = q.z, z = q.w;
    return mat3(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y),
                2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x),
                2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y));
}

struct Gaussian {
    vec3 position;
    vec4 rotation;
    vec3 log_scale;
    vec3 color;
    uint opacity;
    // Longest axis, one standard deviation: a metre is 256, 16 steps an octave.
    uint radius;
    uint part;
    uvec4 joint;
    vec4 joint_weight;
    uvec3 node;
    vec3 node_weight;
};

Gaussian load(uint i) {
    uvec4 a = gaussians[i];
    uvec4 b = gaussians[frame.gaussians + i];
    uvec4 c = gaussians[2u * frame.gaussians + i];
    Gaussian g;
    g.position = frame.position_min.xyz + frame.position_step.xyz * vec3(a.x & 0xffffu, a.x >> 16u, a.y & 0xffffu);
    g.opacity = a.y >> 16u & 0xffu;
    g.radius = a.y >> 24u;
    g.joint = uvec4(a.z, a.z >> 8u, a.z >> 16u, a.z >> 24u) & 0xffu;
    g.joint_weight = unpackUnorm4x8(a.w);
    g.rotation = vec4(unpackSnorm2x16(b.x), unpackSnorm2x16(b.y));
    g.log_scale = vec3(unpackHalf2x16(b.z), unpackHalf2x16(b.w).x);
    g.part = b.w >> 16u;
    g.color = vec3(unpackHalf2x16(c.x), unpackHalf2x16(c.y).x);
    g.node = uvec3(c.y >> 16u, c.z & 0xffffu, c.z >> 16u);
    vec2 weight = unpackUnorm2x16(c.w);
    g.node_weight = vec3(weight, 1.0 - weight.x - weight.y);
    return g;
}

// Steps 2, 4 and 5: the correctives of the rows that were kept, and of the three nodes.
void correct(uint i, inout Gaussian g) {
    uint feature = frame.feature_start + g.part * frame.feature_quads;
    uint block = GAUSSIAN_PLANES * frame.gaussians + 2u * (i / 32u);
    uvec4 head = gaussians[block];
    uvec4 tail = gaussians[block + 1u];
    uint bit = 1u << (i & 31u);
    if ((head.x & bit) != 0u) {
        vec4 rotation = g.rotation + row_dot4(frame.rotation_start, head.w + bitCount(head.x & (bit - 1u)), feature);
        // What is left of the neutral quaternion, of length 1, may be too short to have a direction.
        g.rotation = length(rotation) >= ROTATION_MIN ? rotation : g.rotation;
    }
    if ((head.y & bit) != 0u) {
        g.log_scale += row_dot3(frame.scale_start, tail.x + bitCount(head.y & (bit - 1u)), feature);
    }
    if ((head.z & bit) != 0u) {
        g.color += row_dot3(frame.color_start, tail.y + bitCount(head.z & (bit - 1u)), feature);
    }
    g.position += g.node_weight.x * posed[frame.node_start + g.node.x].xyz + g.node_weight.y * posed[frame.node_start + g.node.y].xyz +
                  g.node_weight.z * posed[frame.node_start + g.node.z].xyz;
}

// Whether a box on the screen is all behind the depth surface.
bool hidden(vec2 center, float radius, float depth) {
    uvec2 low = uvec2(clamp((center - radius - frame.surface_origin) * frame.surface_scale, 0.0, float(SURFACE_FINEST - 1u)));
    uvec2 high = uvec2(clamp((center + radius - frame.surface_origin) * frame.surface_scale, 0.0, float(SURFACE_FINEST - 1u)));
    uint span = max(high.x - low.x, high.y - low.y);
    // The level on which the box meets at most five texels along each side.
    uint level = span <= 3u ? 0u : uint(findMSB(span - 1u)) - 1u;
    if (!(level < SURFACE_LEVELS)) {
        return false;
    }
    // Levels before: a quarter less each, SURFACE_FINEST² · (1 + 1/4 + …).
    uint start = frame.surface_start + SURFACE_FINEST * SURFACE_FINEST / 3u * 4u - (SURFACE_FINEST * SURFACE_FINEST >> (2u * level)) / 3u * 4u;
    low >>= level;
    high >>= level;
    float furthest = 0.0;
    for (uint y = low.y; y <= high.y; ++y) {
        for (uint x = low.x; x <= high.x; ++x) {
            uint at = start + y * (SURFACE_FINEST >> level) + x;
            furthest = max(furthest, posed[at >> 2u][at & 3u]);
        }
    }
    return depth > furthest;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= frame.gaussians) {
        return;
    }
    uint slot = frame.first + i;
    uint key_at = frame.key_start + slot;
    words[key_at] = SORT_DROPPED;
    Gaussian g = load(i);
    if (float(g.opacity) <= frame.cutoff) {
        left_out(FAINT);
        return;
    }
    correct(i, g);

    // Step 6, with the view folded into the joints: rows of the 3 by 4 matrix from canonical space to the camera.
    vec4 r0 = vec4(0.0), r1 = vec4(0.0), r2 = vec4(0.0);
    for (uint k = 0u; k < 4u; ++k) {
        uint at = 3u * g.joint[k];
        r0 += g.joint_weight[k] * frame.joint[at];
        r1 += g.joint_weight[k] * frame.joint[at + 1u];
        r2 += g.joint_weight[k] * frame.joint[at + 2u];
    }
    vec4 x = vec4(g.position, 1.0);
    vec3 p = vec3(dot(r0, x), dot(r1, x), dot(r2, x));
    // Comparisons here and below are written so that NaN fails them.
    if (!(p.z >= frame.near)) {
        left_out(OUTSIDE);
        return;
    }
    vec2 center = frame.focal * p.xy / p.z + frame.center;
    if (!(all(greaterThanEqual(center, vec2(-frame.guard))) && all(lessThanEqual(center, frame.size + frame.guard)))) {
        left_out(OUTSIDE);
        return;
    }

    float key = key_of(p.z);
    float stretched = exp2(float(g.radius) / 16.0 - 16.0) * length(vec3(p.xy / p.z, 1.0)) * max(frame.focal.x, frame.focal.y) / p.z;
    if (frame.surface_start > 0u && hidden(center, reach_of(g.opacity) * (stretched + sqrt(LOW_PASS)), 1.0 - key)) {
        left_out(HIDDEN);
        return;
    }

    // Steps 7 and 8: J (view G R diag(s)), two rows; their products are the covariance.
    mat3 turn = rotation_matrix(normalize(g.rotation));
    vec3 scale = exp(min(g.log_scale, float(LOG_SCALE_MAX)));
    vec2 slope = clamp(p.xy / p.z, frame.derivative_min, frame.derivative_max);
    vec3 u = frame.focal.x / p.z * (r0.xyz - slope.x * r2.xyz);
    vec3 v = frame.focal.y / p.z * (r1.xyz - slope.y * r2.xyz);
    vec3 mu = vec3(dot(u, turn[0]), dot(u, turn[1]), dot(u, turn[2])) * scale;
    vec3 mv = vec3(dot(v, turn[0]), dot(v, turn[1]), dot(v, turn[2])) * scale;
    vec3 covariance = vec3(dot(mu, mu) + LOW_PASS, dot(mu, mv), dot(mv, mv) + LOW_PASS);
    // |u × v|² is the determinant of the covariance before the low-pass (Lagrange), free of cancellation for needles.
    vec3 across = cross(mu, mv);
    float determinant = dot(across, across) + LOW_PASS * (covariance.x + covariance.z - LOW_PASS);
    vec2 extent = reach_of(g.opacity) * sqrt(covariance.xz);
    if (!(determinant > 0.0 && covariance.x <= VARIANCE_MAX && covariance.z <= VARIANCE_MAX)) {
        left_out(DEGENERATE);
        return;
    }
    if (!(all(greaterThan(center + extent, vec2(0.0))) && all(lessThan(center - extent, frame.size)))) {
        left_out(OUTSIDE);
        return;
    }

    uvec4 packed = pack_splat(center, covariance, determinant, clamp(g.color, 0.0, 1.0), g.opacity);
    for (uint k = 0u; k < 4u; ++k) {
        words[4u * slot + k] = packed[k];
    }
    words[key_at] = min(uint(key * float(frame.key_max)), frame.key_max);
}
