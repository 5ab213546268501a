// The greatest number of each window, with stride 1.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "perceptual/maps.glsl"

layout(constant_id = 4) const uint WINDOW = 2u;

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= WIDTH * HEIGHT) {
        return;
    }
    uvec2 at = uvec2(pixel % WIDTH, pixel / WIDTH);
    float greatest = read_at(at);
    for (uint k = 1u; k < WINDOW * WINDOW; ++k) {
        greatest = max(greatest, read_at(at + uvec2(k % WINDOW, k / WINDOW)));
    }
    written[PLANE + pixel] = greatest;
}
