// How the derivative of a Gaussian's attributes lies in memory, four vectors each:
// 0: rotation, w x y z. 1: log scale, and the logit of the opacity. 2: colour, and the signs of the
// correctives, two bits a number (sign_bits). 3: position in canonical space.
// Those of attributes are without the weights on correctives, which train/corrective.glsl adds.
uint gradient_at(uint view, uint gaussian) {
    return 4u * (view * GAUSSIANS + gaussian);
}

// −1, 0 or 1 as two bits at place `at`.
uint sign_bits(float value, uint at) {
    return (value > 0.0 ? 1u : value < 0.0 ? 2u : 0u) << (2u * at);
}

float sign_at(uint bits, uint at) {
    uint two = bits >> (2u * at) & 3u;
    return two == 1u ? 1.0 : two == 2u ? -1.0 : 0.0;
}
