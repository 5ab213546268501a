// The pose cache: a posed Gaussian, which stays valid while only the camera moves. Six words, or
// seven where an avatar says from where its Gaussians are drawn, in the space of the camera for which
// they were written. A position has 24 bits a coordinate: with 16, 30 µm on a body, Gaussians of
// nearly one depth change places.
//
//   three for each Gaussian   x y (high 16 bits each) | z (high 16 bits), size (8 bits), opacity |
//                             x, y, z (low 8 bits each)
//   three for each Gaussian   L, lower triangular with Σ = L Lᵀ, in 1023rds of the size, 11 bits
//                             each, and RGB, 10 bits each:
//                             L00 L10, red | L11 L20, green | L21 L22, blue
//   one for each Gaussian     where it faces (project/facing.glsl)

// Where the word is that says where a Gaussian faces.
uint cached_facing_at(uint index) {
    return frame.cache_start + POSE_CACHE_WORDS * frame.drawn + index;
}

// Share of a coordinate's codes for what lies beyond each end of its range.
const float CACHE_TAIL = 1.0 / 64.0;
// The largest code of a coordinate.
const float CACHE_CODES = 16777215.0;

// Most codes are for 0 to 1. Beyond, they get ever coarser, up to a thousand times that range.
uvec3 encode_position(vec3 at) {
    vec3 low = CACHE_TAIL / (1.0 - min(at, 0.0));
    vec3 high = 1.0 - CACHE_TAIL / max(at, 1.0);
    vec3 inside = CACHE_TAIL + (1.0 - 2.0 * CACHE_TAIL) * clamp(at, 0.0, 1.0);
    vec3 code = mix(mix(inside, low, lessThan(at, vec3(0.0))), high, greaterThan(at, vec3(1.0)));
    return uvec3(round(CACHE_CODES * clamp(code, 0.0, 1.0)));
}

vec3 decode_position(uvec3 code) {
    vec3 at = vec3(code) / CACHE_CODES;
    vec3 inside = (at - CACHE_TAIL) / (1.0 - 2.0 * CACHE_TAIL);
    vec3 low = 1.0 - CACHE_TAIL / max(at, 0.5 / CACHE_CODES);
    vec3 high = CACHE_TAIL / max(1.0 - at, 0.5 / CACHE_CODES);
    return mix(mix(inside, low, lessThan(at, vec3(CACHE_TAIL))), high,
               greaterThan(at, vec3(1.0 - CACHE_TAIL)));
}

// Size, metres: the largest standard deviation along one of the space's axes, which bounds every
// number of L; rounded up to eight steps an octave, from 2⁻¹⁹ of frame.cache_unit on.
float cached_size(uvec3 words) {
    return frame.cache_unit * exp2(float(words.y >> 16u & 0xffu) / 8.0 - 19.0);
}

// The first three words. `m`: the axes in camera space. NaN is written as opacity 0, which is never
// drawn.
uvec3 cache_position(vec3 p, mat3 m, uint opacity) {
    mat3 t = transpose(m);
    float size = sqrt(max(max(dot(t[0], t[0]), dot(t[1], t[1])), dot(t[2], t[2])));
    float code = ceil(8.0 * log2(max(size / frame.cache_unit, 1e-30)) + 152.0);
    bool valid = all(lessThan(abs(p), vec3(1e30))) && size <= 1e18;
    vec3 relative = valid ? (p - frame.cache_min.xyz) / frame.cache_size.xyz : vec3(0.0);
    uvec3 at = encode_position(relative);
    uvec3 high = at >> 8u, low = at & 0xffu;
    return uvec3(high.x | high.y << 16u,
                 high.z | uint(clamp(valid ? code : 0.0, 0.0, 255.0)) << 16u |
                     (valid ? opacity : 0u) << 24u,
                 low.x | low.y << 8u | low.z << 16u);
}

// The other three words. `words`: the first three.
uvec3 cache_shape(mat3 m, uvec3 words, vec3 color) {
    // Gram–Schmidt on the rows: a needle's short axes come from a difference of vectors, not of
    // squares, which would cancel.
    vec3 a = vec3(m[0].x, m[1].x, m[2].x);
    vec3 b = vec3(m[0].y, m[1].y, m[2].y);
    vec3 c = vec3(m[0].z, m[1].z, m[2].z);
    float l00 = length(a);
    a = l00 > 0.0 ? a / l00 : vec3(0.0);
    float l10 = dot(b, a);
    b -= l10 * a;
    float l11 = length(b);
    b = l11 > 0.0 ? b / l11 : vec3(0.0);
    float l20 = dot(c, a);
    float l21 = dot(c, b);
    float l22 = length(c - l20 * a - l21 * b);
    float unit = 1023.0 / cached_size(words);
    uvec3 first = uvec3(clamp(round(vec3(l00, l11, l21) * unit) + 1023.0, 0.0, 2046.0));
    uvec3 second = uvec3(clamp(round(vec3(l10, l20, l22) * unit) + 1023.0, 0.0, 2046.0));
    return first | second << 11u | uvec3(round(color * 1023.0)) << 22u;
}

// Mean, metres.
vec3 cached_position(uvec3 words) {
    uvec3 high = uvec3(words.x & 0xffffu, words.x >> 16u, words.y & 0xffffu);
    uvec3 code = high << 8u | uvec3(words.z, words.z >> 8u, words.z >> 16u) & 0xffu;
    return frame.cache_min.xyz + frame.cache_size.xyz * decode_position(code);
}

// The columns of L, metres.
mat3 cached_axes(uvec3 words, uvec3 shape) {
    float unit = cached_size(words) / 1023.0;
    vec3 first = (vec3(shape & 0x7ffu) - 1023.0) * unit;
    vec3 second = (vec3(shape >> 11u & 0x7ffu) - 1023.0) * unit;
    return mat3(first.x, second.x, second.y, 0.0, first.y, first.z, 0.0, 0.0, second.z);
}

vec3 cached_color(uvec3 shape) { return vec3(shape >> 22u) / 1023.0; }
