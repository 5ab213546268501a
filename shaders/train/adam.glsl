// Adam (Kingma and Ba, 2015) with bias correction; weight decay apart from it, as in AdamW. The
// moments of a number: m and v.
struct Moments {
    float m;
    float v;
};

// The number after a step. `decay`: weight decay. `correction`: 1 / (1 − β₁ᵗ), 1 / (1 − β₂ᵗ).
float adam_step(float value, float gradient, float rate, float decay, vec2 correction, inout Moments moments) {
    moments.m = block.adam.x * moments.m + (1.0 - block.adam.x) * gradient;
    moments.v = block.adam.y * moments.v + (1.0 - block.adam.y) * gradient * gradient;
    float change = moments.m * correction.x / (sqrt(moments.v * correction.y) + block.adam.z);
    return value - rate * (change + decay * value);
}
