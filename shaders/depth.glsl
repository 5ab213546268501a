// Where in the keys a depth is, 0 to 1: linear over the range that the avatar is expected in, and still rising beyond its ends, where
// correctives larger than expected may carry a Gaussian.
float key_of(float depth) {
    const float tail = 1.0 / 64.0;
    float at = (frame.key_far - depth) * frame.key_scale;
    float inside = tail + (1.0 - 2.0 * tail) * clamp(at, 0.0, 1.0);
    return at < 0.0 ? tail / (1.0 - at) : at > 1.0 ? 1.0 - tail / at : inside;
}
