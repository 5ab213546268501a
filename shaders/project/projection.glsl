// From a Gaussian in the camera's space to a splat and its key: culling and projection (model.md,
// step 8). The including shader declares `words`, the splats' buffer: four words a Gaussian, then
// from frame.key_start on the keys, then from frame.count_start on the sort's first counts.
#ifdef WEB
// In WGSL all accesses to an array with atomics are atomic, so the counts have a buffer of their
// own.
layout(std430, set = 0, binding = 6) buffer Counts { uint counts[]; };
#define COUNTS counts
const uint COUNTS_AT = 0u;
#else
#define COUNTS words
PARAMETER(2, uint, COUNTS_AT, 0u)
#endif
#define FIRST_COUNTS COUNTS
#define FIRST_COUNTS_AT frame.count_start
#define FIRST_COUNTS_TILE frame.count_tile
#include "sort/first_counts.glsl"
#include "common/footprint.glsl"
#include "project/culled.glsl"

// Projects a mean `p` in camera space, metres: gives its centre in the image, px, and its key, 0 to
// 1. False if the Gaussian is culled. Comparisons are written so that NaN fails them.
bool project_center(vec3 p, out vec2 center, out float key) {
    center = vec2(0.0);
    key = 0.0;
    if (!(p.z >= frame.near)) {
        count_culled(OUTSIDE);
        return false;
    }
    center = frame.focal * p.xy / p.z + frame.center;
    key = key_of(p.z);
    return true;
}

// Whether a Gaussian certainly misses what is drawn, which `write_splat` finds out for all: a
// shorter way for those whose centre lies outside. `rows`: see there. `deviation`: no less than the
// largest standard deviation, in the rows' space.
bool misses_area(vec3 p, vec2 center, mat3 rows, float deviation) {
    vec2 beyond = max(frame.area.xy - center, center - frame.area.zw);
    if (!(max(beyond.x, beyond.y) > 0.0)) {
        return false;
    }
    vec3 squares = vec3(dot(rows[0], rows[0]), dot(rows[1], rows[1]), dot(rows[2], rows[2]));
    float size = sqrt(max(max(squares.x, squares.y), squares.z)) * deviation;
    vec2 slope = max(abs(frame.derivative_min), abs(frame.derivative_max));
    vec2 footprint = abs(frame.focal) / p.z * (1.0 + slope) * size + sqrt(frame.low_pass);
    vec2 reach = visible_radius(255.0) * sqrt(frame.covariance_scale) * footprint;
    // The hundredth is for rounding.
    bvec2 missed = greaterThan(beyond, 1.01 * max(frame.area_reach, 0.0) * reach);
    if (any(missed)) {
        count_culled(OUTSIDE);
    }
    return any(missed);
}

// Opacity, of 255, of a Gaussian that also stands for those that the level of detail skips. The
// number of rounds is not the block's (common/opaque.glsl).
uint detail_opacity(uint opacity) {
    float through = 1.0 - float(opacity) / 255.0;
    for (uint level = 0u; level < DETAIL_COARSEST; ++level) {
        through = mix(through, through * through, level < frame.detail_level);
    }
    return uint(round(255.0 * (1.0 - through)));
}

// Writes the splat of a Gaussian; gives its key, SORT_CULLED if it covers nothing. The columns of
// `axes` are the Gaussian's axes in some space, `rows` those of the matrix from there to the
// camera. `fade`: how much of the opacity is left of what faces away.
uint write_splat(uint index, vec3 p, vec2 center, float key, mat3 rows, mat3 axes, vec3 color,
                 uint opacity, float fade) {
    vec2 slope = clamp(p.xy / p.z, frame.derivative_min, frame.derivative_max);
    Footprint footprint = footprint_of(p, frame.focal, slope, rows, axes, frame.low_pass);
    vec3 covariance = footprint.covariance;
    float determinant = footprint.determinant;
    if (!is_drawable(footprint)) {
        count_culled(DEGENERATE);
        return SORT_CULLED;
    }
    opacity = detail_opacity(opacity);
    float kept = sqrt(footprint.unfiltered / determinant);
    kept = (1.0 - frame.compensation) + frame.compensation * kept;
    opacity = uint(round(float(opacity) * kept * fade));
    if (float(opacity) <= frame.cutoff) {
        count_culled(FAINT);
        return SORT_CULLED;
    }
    covariance *= frame.covariance_scale;
    determinant *= frame.covariance_scale * frame.covariance_scale;
    // What shows decides, not what is drawn for it: in an atlas a splat is cut off by this.
    vec2 half_sides = visible_radius(float(opacity)) * sqrt(covariance.xz);
    vec2 reach = frame.area_reach * half_sides;
    if (!(all(greaterThan(center + reach, frame.area.xy)) &&
          all(lessThan(center - reach, frame.area.zw)))) {
        count_culled(OUTSIDE);
        return SORT_CULLED;
    }
    uvec4 packed = pack_splat(center, covariance, determinant, clamp(color, 0.0, 1.0), opacity);
    uint at = 4u * (frame.first_splat + index);
    words[at] = packed.x;
    words[at + 1u] = packed.y;
    words[at + 2u] = packed.z;
    words[at + 3u] = packed.w;
    return min(uint(key * float(frame.key_max)), frame.key_max);
}

// Writes and counts a key.
void write_key(uint index, uint key) {
    uint at = frame.first_splat + index;
    count_first_digit(key, key != SORT_CULLED, at);
    words[frame.key_start + at] = key;
}
