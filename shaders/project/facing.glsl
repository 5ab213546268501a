// From where a Gaussian is drawn (model.md, step 8): the cone of avatar::facing. In the model it is
// a word, of whose bytes the first two are the axis and the third the limit; in the pose cache the
// axis has 12 bits a coordinate, and the limit the last 8.

// A direction from its octahedral map, −1 to 1.
vec3 octahedral_direction(vec2 uv) {
    vec3 direction = vec3(uv, 1.0 - abs(uv.x) - abs(uv.y));
    vec2 below = vec2(max(-direction.z, 0.0));
    direction.xy += mix(below, -below, greaterThanEqual(uv, vec2(0.0)));
    return normalize(direction);
}

// The octahedral map of a direction of any length but 0.
vec2 octahedral_map(vec3 direction) {
    vec3 d = direction / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    vec2 folded = (1.0 - abs(d.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(d.xy, vec2(0.0)));
    return d.z >= 0.0 ? d.xy : folded;
}

// The axis in the canonical pose.
vec3 facing_axis(uint word) {
    return octahedral_direction(vec2(word & 0xffu, word >> 8u & 0xffu) / 127.5 - 1.0);
}

uint facing_limit_code(uint word) { return word >> 16u & 0xffu; }

// A posed axis and its limit's code as a word of the pose cache.
uint cache_facing(vec3 axis, uint limit) {
    bool has_length = dot(axis, axis) > 0.0;
    vec2 uv = octahedral_map(has_length ? axis : vec3(0.0, 0.0, 1.0));
    uvec2 code = uvec2(round(clamp(2047.5 * (uv + 1.0), 0.0, 4095.0)));
    return code.x | code.y << 12u | limit << 24u;
}

vec3 cached_axis(uint word) {
    return octahedral_direction(vec2(word & 0xfffu, word >> 12u & 0xfffu) / 2047.5 - 1.0);
}

// How much of its opacity is left, 0 to 1. `axis` and the mean `p` are in camera space.
float facing_fade(vec3 axis, uint limit_code, vec3 p) {
    float limit = float(limit_code) / FACING_STEPS - 1.0 - FACING_FADE;
    float lengths = sqrt(dot(axis, axis) * dot(p, p));
    float cosine = -dot(axis, p) / max(lengths, 1e-30);
    return clamp((cosine - limit) / FACING_FADE, 0.0, 1.0);
}
