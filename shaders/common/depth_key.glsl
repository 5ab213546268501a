// The depth key of a depth, 0 (far) to 1 (near): linear over the range in which the avatar is
// expected. Beyond the range it still rises, since correctives larger than expected may move a
// Gaussian there.
float key_of(float depth) {
    const float tail = 1.0 / 64.0;
    float at = (frame.key_far - depth) * frame.key_scale;
    float inside = tail + (1.0 - 2.0 * tail) * clamp(at, 0.0, 1.0);
    return at < 0.0 ? tail / (1.0 - at) : at > 1.0 ? 1.0 - tail / at : inside;
}
