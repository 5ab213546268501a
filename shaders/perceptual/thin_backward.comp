// The derivative of rows and columns that were kept: none for the others.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "perceptual/maps.glsl"

layout(constant_id = 4) const uint STEP = 2u;

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= WIDTH * HEIGHT) {
        return;
    }
    uvec2 own = uvec2(pixel % WIDTH, pixel / WIDTH);
    bool was_kept = own.x % STEP == 0u && own.y % STEP == 0u;
    written[PLANE + pixel] = was_kept ? read_at(own / STEP) : 0.0;
}
