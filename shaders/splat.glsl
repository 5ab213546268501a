// The 16-byte splat: what `splats` writes and `raster` reads.
//
//   word 0: x (POSITION_BITS, fixed point), red (10 bits), low 2 bits of blue
//   word 1: y (POSITION_BITS, fixed point), green (10 bits)
//   word 2: longer axis, one standard deviation, px, two f16
//   word 3: length of the shorter axis, px, f16; opacity (8 bits); high 8 bits of blue

#define LOW_PASS 0.3
#define ROTATION_MIN 1e-3
#define VARIANCE_MAX 1e18

// How many standard deviations from its centre a Gaussian reaches the cutoff.
float reach_of(uint opacity) {
    return sqrt(2.0 * log(max(max(float(opacity), frame.hull_opacity) / frame.cutoff, 1.0)));
}

// `covariance` is xx, xy, yy in px²; `determinant` its determinant, worked out without cancellation.
uvec4 pack_splat(vec2 center, vec3 covariance, float determinant, vec3 color, uint opacity) {
    float half_difference = 0.5 * (covariance.x - covariance.z);
    float root = sqrt(half_difference * half_difference + covariance.y * covariance.y);
    float longer = 0.5 * (covariance.x + covariance.z) + root;
    vec2 direction = half_difference >= 0.0 ? vec2(half_difference + root, covariance.y) : vec2(covariance.y, root - half_difference);
    float size = length(direction);
    direction = size > 0.0 ? direction / size : vec2(1.0, 0.0);
    // Shortened as a whole where f16 can't hold it, so that it keeps its direction.
    vec2 axis = min(sqrt(longer), 65504.0) * direction;
    float shorter = sqrt(determinant / longer);
    uvec2 at = uvec2(clamp(round((center + frame.guard) * frame.fixed_scale), 0.0, float((1u << POSITION_BITS) - 1u)));
    uvec3 rgb = uvec3(round(color * 1023.0));
    return uvec4(at.x | rgb.r << POSITION_BITS | rgb.b << 30u, at.y | rgb.g << POSITION_BITS, packHalf2x16(axis),
                 packHalf2x16(vec2(min(shorter, 65504.0), 0.0)) | opacity << 16u | rgb.b >> 2u << 24u);
}

struct Splat {
    vec2 center;
    vec2 axis;
    float shorter;
    vec3 color;
    uint opacity;
};

// A splat's coordinates as they are kept.
vec2 steps_of(uvec4 words) { return vec2(words.xy & (1u << POSITION_BITS) - 1u); }

Splat unpack_splat(uvec4 words) {
    Splat splat;
    splat.center = steps_of(words) / frame.fixed_scale - frame.guard;
    splat.axis = unpackHalf2x16(words.z);
    splat.shorter = unpackHalf2x16(words.w).x;
    uint blue = words.w >> 24u << 2u | words.x >> 30u;
    splat.color = vec3(words.x >> POSITION_BITS & 1023u, words.y >> POSITION_BITS & 1023u, blue) / 1023.0;
    splat.opacity = words.w >> 16u & 0xffu;
    return splat;
}
