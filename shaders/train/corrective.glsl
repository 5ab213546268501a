// The derivative of a Gaussian's correctives: that of its attributes, and that of the weights on
// the correctives themselves.
vec4 of_rotation(vec4 of, uint signs) {
    vec4 own = vec4(sign_at(signs, 0u), sign_at(signs, 1u), sign_at(signs, 2u), sign_at(signs, 3u));
    return of + block.corrective_weights.x * own;
}

vec3 of_scale(vec3 of, uint signs) {
    vec3 own = vec3(sign_at(signs, 4u), sign_at(signs, 5u), sign_at(signs, 6u));
    return of + block.corrective_weights.y * own;
}

vec3 of_color(vec3 of, uint signs) {
    vec3 own = vec3(sign_at(signs, 7u), sign_at(signs, 8u), sign_at(signs, 9u));
    return of + block.corrective_weights.z * own;
}
