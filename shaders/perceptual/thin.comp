// Every so many rows and columns alone, from the first.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "perceptual/maps.glsl"

layout(constant_id = 4) const uint STEP = 2u;

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel < WIDTH * HEIGHT) {
        written[PLANE + pixel] = read_at(STEP * uvec2(pixel % WIDTH, pixel / WIDTH));
    }
}
