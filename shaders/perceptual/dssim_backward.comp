// The derivative of D-SSIM with respect to the first picture, from those with respect to means.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "perceptual/dssim.glsl"

// Shape: 3 · 3 · height · width.
layout(std430, set = 0, binding = 2) readonly buffer OfMeans { float of_means[]; };
// Shape: 3 · height · width.
layout(std430, set = 0, binding = 3) writeonly buffer Written { float written[]; };

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= PLANE) {
        return;
    }
    uint first = gl_WorkGroupID.y * PLANE;
    ivec2 own = ivec2(pixel % WIDTH, pixel / WIDTH);
    vec3 sum = vec3(0.0);
    for (int y = -RADIUS; y <= RADIUS; ++y) {
        for (int x = -RADIUS; x <= RADIUS; ++x) {
            ivec2 at = own + ivec2(x, y);
            if (is_inside(at)) {
                uint place = first + uint(at.y) * WIDTH + uint(at.x);
                vec3 of = vec3(of_means[place], of_means[3u * PLANE + place], of_means[6u * PLANE + place]);
                sum += weight(x, y) * of;
            }
        }
    }
    uint place = first + pixel;
    written[place] = sum.x + 2.0 * read_maps[place] * sum.y + read_maps[3u * PLANE + place] * sum.z;
}
