// Step 8 (model.md), once a Gaussian is in the camera's space: culling, projection, the splat and its key. For kernels that have `posed`,
// the pose buffer, and `words`, the splats' buffer: four words a Gaussian, then from frame.key_start on the keys, two a word where
// frame.half_keys says so, then from frame.count_start on the sort's first counts.
#ifdef WEB
// What is added to by atomics is read by them alone, which the splats are not to pay for.
layout(std430, set = 0, binding = 6) buffer Counts { uint counts[]; };
#define SORT_FIRST_COUNTS counts
#else
#define SORT_FIRST_COUNTS words
#endif
#define SORT_FIRST_AT frame.count_start
#define SORT_FIRST_TILE frame.count_tile
#include "sort_fused.glsl"
#include "left_out.glsl"
#include "pose.glsl"

shared uint key_of_lane[SPLATS_SIZE];

// Whether a box on the screen is all behind the depth surface, by half a texel to spare: a texel's depth is that of its middle.
bool hidden(vec2 center, float radius, float depth) {
    uvec2 low = uvec2(clamp((center - radius - frame.surface_origin) * frame.surface_scale - 0.5, 0.0, float(SURFACE_FINEST - 1u)));
    uvec2 high = uvec2(clamp((center + radius - frame.surface_origin) * frame.surface_scale + 0.5, 0.0, float(SURFACE_FINEST - 1u)));
    uint span = max(high.x - low.x, high.y - low.y);
    // The level on which the box meets at most five texels along each side.
    uint level = span <= 3u ? 0u : uint(findMSB(span - 1u)) - 1u;
    if (!(level < SURFACE_LEVELS)) {
        return false;
    }
    // Levels before: a quarter less each, SURFACE_FINEST² · (1 + 1/4 + …).
    const uint third = SURFACE_FINEST * SURFACE_FINEST / 3u;
    uint width = SURFACE_FINEST >> level;
    uint start = 4u * (third - (third >> 2u * level));
    low >>= level;
    high >>= level;
    float furthest = 0.0;
    uint x = low.x & ~3u, y = low.y;
    do {
        vec4 columns = float(x) + vec4(0.0, 1.0, 2.0, 3.0);
        bvec4 left = lessThan(columns, vec4(low.x)), right = greaterThan(columns, vec4(high.x));
        vec4 four = mix(mix(furthest_of(start + y * width + x), vec4(0.0), left), vec4(0.0), right);
        furthest = max(furthest, max(max(four.x, four.y), max(four.z, four.w)));
        bool next = x + 4u > high.x;
        x = next ? low.x & ~3u : x + 4u;
        y += next ? 1u : 0u;
    } while (y <= high.y);
    return depth > furthest;
}

// Where a Gaussian at `p`, camera space, lands in the picture and in the keys (0 to 1). False: nothing of it shows. `longest` is no less
// than its longest axis, metres. Comparisons are written so that NaN fails them.
bool lands(vec3 p, float longest, out vec2 center, out float key) {
    center = vec2(0.0);
    key = 0.0;
    if (!(p.z >= frame.near)) {
        left_out(OUTSIDE);
        return false;
    }
    center = frame.focal * p.xy / p.z + frame.center;
    if (!(all(greaterThanEqual(center, vec2(-frame.guard))) && all(lessThanEqual(center, frame.size + frame.guard)))) {
        left_out(OUTSIDE);
        return false;
    }
    key = key_of(p.z);
    float stretched = longest * length(vec3(p.xy / p.z, 1.0)) * max(frame.focal.x, frame.focal.y) / p.z;
    // Its opacity is not known yet: as far as an opaque one reaches.
    if (frame.surface_start > 0u && hidden(center, reach_of(255u) * sqrt(frame.spread) * (stretched + sqrt(LOW_PASS)), 1.0 - key)) {
        left_out(HIDDEN);
        return false;
    }
    return true;
}

// What stands for as many Gaussians as are left out for one that is drawn, of this opacity.
uint opacity_of(uint opacity) {
    float through = 1.0 - float(opacity) / 255.0;
    for (uint level = 0u; level < frame.level; ++level) {
        through *= through;
    }
    return uint(round(255.0 * (1.0 - through)));
}

// Writes the splat of a Gaussian whose axes are the columns of `axes` in a space that the rows r0, r1, r2 turn to the camera's. Gives its
// key, SORT_DROPPED where it covers nothing.
uint draw(uint slot, vec3 p, vec2 center, float key, mat3 rows, mat3 axes, vec3 color, uint opacity) {
    vec2 slope = clamp(p.xy / p.z, frame.derivative_min, frame.derivative_max);
    vec3 mu = frame.focal.x / p.z * (rows[0] - slope.x * rows[2]) * axes;
    vec3 mv = frame.focal.y / p.z * (rows[1] - slope.y * rows[2]) * axes;
    vec3 covariance = vec3(dot(mu, mu) + LOW_PASS, dot(mu, mv), dot(mv, mv) + LOW_PASS);
    // |u × v|² is the determinant of the covariance before the low-pass (Lagrange), free of cancellation for needles.
    vec3 across = cross(mu, mv);
    float determinant = dot(across, across) + LOW_PASS * (covariance.x + covariance.z - LOW_PASS);
    if (!(determinant > 0.0 && covariance.x <= VARIANCE_MAX && covariance.z <= VARIANCE_MAX)) {
        left_out(DEGENERATE);
        return SORT_DROPPED;
    }
    covariance *= frame.spread;
    determinant *= frame.spread * frame.spread;
    opacity = opacity_of(opacity);
    vec2 extent = reach_of(opacity) * sqrt(covariance.xz);
    if (!(all(greaterThan(center + extent, vec2(0.0))) && all(lessThan(center - extent, frame.size)))) {
        left_out(OUTSIDE);
        return SORT_DROPPED;
    }
    uvec4 packed = pack_splat(center, covariance, determinant, clamp(color, 0.0, 1.0), opacity);
    uint at = 4u * (frame.first + slot);
    words[at] = packed.x;
    words[at + 1u] = packed.y;
    words[at + 2u] = packed.z;
    words[at + 3u] = packed.w;
    return min(uint(key * float(frame.key_max)), frame.key_max);
}

// Writes and counts a workgroup's keys; every invocation must come here.
void write_key(uint slot, uint key) {
    uint lane = gl_LocalInvocationID.x;
    uint at = frame.first + slot;
    sort_count_first(key, key != SORT_DROPPED, at);
    if (frame.half_keys == 0u) {
        // An odd number is made even: two keys of a word are of one avatar.
        if (slot < frame.drawn + (frame.drawn & 1u)) {
            words[frame.key_start + at] = key;
        }
        return;
    }
    key_of_lane[lane] = key;
    barrier();
    if ((lane & 1u) == 0u && slot < frame.drawn) {
        words[frame.key_start + (at >> 1u)] = key & 0xffffu | key_of_lane[lane + 1u] << 16u;
    }
}
