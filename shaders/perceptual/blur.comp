// The blur that halves feature maps: [1, 2, 1] / 4 across and down with stride 2, after two mirrored
// pixels were added to each side.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "perceptual/maps.glsl"
#include "perceptual/blur.glsl"

// 1: negative numbers become 0.
layout(constant_id = 4) const uint RECTIFIES = 0u;

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= WIDTH * HEIGHT) {
        return;
    }
    uvec2 at = uvec2(pixel % WIDTH, pixel / WIDTH);
    float sum = 0.0;
    [[unroll]] for (uint y = 0u; y < 3u; ++y) {
        float line = 0.0;
        [[unroll]] for (uint x = 0u; x < 3u; ++x) {
            line += SHARES[x] * read_at(uvec2(under(at.x, x, READ_WIDTH), under(at.y, y, READ_HEIGHT)));
        }
        sum += SHARES[y] * line;
    }
    written[PLANE + pixel] = RECTIFIES == 1u ? max(sum, 0.0) : sum;
}
