// The derivative of the greatest number of each window: a window's goes to the first of its pixels,
// row by row, that has it.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "perceptual/maps.glsl"

layout(constant_id = 4) const uint WINDOW = 2u;
// What was read, and what was written.
layout(std430, set = 0, binding = 3) readonly buffer Input { float input_maps[]; };
layout(std430, set = 0, binding = 4) readonly buffer Greatest { float greatest[]; };

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= WIDTH * HEIGHT) {
        return;
    }
    uvec2 own = uvec2(pixel % WIDTH, pixel / WIDTH);
    float number = input_maps[PLANE + pixel];
    float sum = 0.0;
    for (uint k = 0u; k < WINDOW * WINDOW; ++k) {
        uvec2 inside = uvec2(k % WINDOW, k / WINDOW);
        if (any(lessThan(own, inside))) {
            continue;
        }
        uvec2 at = own - inside;
        if (at.x >= READ_WIDTH || at.y >= READ_HEIGHT) {
            continue;
        }
        if (number != greatest[READ_PLANE + at.y * READ_WIDTH + at.x]) {
            continue;
        }
        bool is_first = true;
        for (uint before = 0u; before < k; ++before) {
            uvec2 other = at + uvec2(before % WINDOW, before / WINDOW);
            is_first = is_first && input_maps[PLANE + other.y * WIDTH + other.x] != number;
        }
        sum += is_first ? read_at(at) : 0.0;
    }
    written[PLANE + pixel] = sum;
}
