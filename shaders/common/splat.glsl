// The 16-byte splat: a projected Gaussian, written by `project` and read by `raster`.
//
//   word 0: x (POSITION_BITS, fixed point), red (10 bits), low 2 bits of blue
//   word 1: y (POSITION_BITS, fixed point), green (10 bits), the grid of x and y (2 bits)
//   word 2: longer axis, one standard deviation, px, two f16
//   word 3: length of the shorter axis, px, f16; opacity (8 bits); high 8 bits of blue

// How far a splat of an opacity, of 255, shows, in standard deviations: to where it falls to the
// cutoff.
float visible_radius(float opacity) {
    return sqrt(2.0 * log(max(opacity / frame.cutoff, 1.0)));
}

// How far it is drawn.
float radius_of(uint opacity) { return visible_radius(max(float(opacity), frame.quad_opacity)); }

// Of the grids of centres (layout::CenterGrids) the finest that holds one, px.
uint grid_of(vec2 center) {
    const float finer = float(1u << CENTER_GRID_BITS);
    vec2 beyond = max(-center, 0.5 * center);
    float far = max(beyond.x, beyond.y) / frame.guard;
    return uint(far > 1.0) + uint(far > finer) + uint(far > finer * finer);
}

// How many times as coarse as the finest a splat's grid is.
float coarseness_of(uvec4 words) {
    return uintBitsToFloat((words.y >> 30u) * (CENTER_GRID_BITS << 23u) + floatBitsToUint(1.0));
}

// `covariance`: xx, xy, yy in px². `determinant`: of the covariance, computed without cancellation.
uvec4 pack_splat(vec2 center, vec3 covariance, float determinant, vec3 color, uint opacity) {
    float half_difference = 0.5 * (covariance.x - covariance.z);
    float root = sqrt(half_difference * half_difference + covariance.y * covariance.y);
    float longer = 0.5 * (covariance.x + covariance.z) + root;
    vec2 direction = half_difference >= 0.0 ? vec2(half_difference + root, covariance.y)
                                            : vec2(covariance.y, root - half_difference);
    // If f32 can't tell its axes apart it is round, and any direction serves. The squares of what
    // is left of the difference would be too small for f32: the direction's length would not be 1.
    direction = root > 1e-8 * longer ? normalize(direction) : vec2(1.0, 0.0);
    // The length is clamped to what f16 holds, not each component: the direction stays.
    vec2 axis = min(sqrt(longer), F16_MAX) * direction;
    float shorter = sqrt(determinant / longer);
    const float last = float((1u << POSITION_BITS) - 1u);
    uint grid = grid_of(center);
    center *= exp2(-float(grid * CENTER_GRID_BITS));
    uvec2 at = uvec2(clamp(round((center + frame.guard) * frame.fixed_scale), 0.0, last));
    uvec3 rgb = uvec3(round(color * 1023.0));
    return uvec4(at.x | rgb.r << POSITION_BITS | rgb.b << 30u, at.y | rgb.g << POSITION_BITS | grid << 30u,
                 packHalf2x16(axis),
                 packHalf2x16(vec2(min(shorter, F16_MAX), 0.0)) | opacity << 16u |
                     rgb.b >> 2u << 24u);
}

struct Splat {
    // px
    vec2 center;
    vec2 axis;
    float shorter;
    vec3 color;
    // Of 255.
    uint opacity;
};

// A splat's centre in steps of its grid, from the grid's corner.
vec2 fixed_center(uvec4 words) { return vec2(words.xy & (1u << POSITION_BITS) - 1u); }

Splat unpack_splat(uvec4 words) {
    Splat splat;
    splat.center = (fixed_center(words) / frame.fixed_scale - frame.guard) * coarseness_of(words);
    splat.axis = unpackHalf2x16(words.z);
    splat.shorter = unpackHalf2x16(words.w).x;
    uint blue = words.w >> 24u << 2u | words.x >> 30u;
    uint red = words.x >> POSITION_BITS & 1023u;
    uint green = words.y >> POSITION_BITS & 1023u;
    splat.color = vec3(red, green, blue) / 1023.0;
    splat.opacity = words.w >> 16u & 0xffu;
    return splat;
}
