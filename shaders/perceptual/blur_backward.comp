// The derivative of the blur with respect to what it read: of the four written pixels of a line
// that may have read one, each gives its share as often as it did.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "perceptual/maps.glsl"
#include "perceptual/blur.glsl"

// What written pixel `at` of a line counts the pixel `own`.
float share(uint at, uint own, uint length, uint written_length) {
    float sum = 0.0;
    if (at < written_length) {
        [[unroll]] for (uint k = 0u; k < 3u; ++k) {
            sum += under(at, k, length) == own ? SHARES[k] : 0.0;
        }
    }
    return sum;
}

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= WIDTH * HEIGHT) {
        return;
    }
    uvec2 own = uvec2(pixel % WIDTH, pixel / WIDTH);
    // Wraps around before the first.
    uvec2 first = own / 2u - 1u;
    float sum = 0.0;
    [[unroll]] for (uint y = 0u; y < 4u; ++y) {
        float of_row = share(first.y + y, own.y, HEIGHT, READ_HEIGHT);
        [[unroll]] for (uint x = 0u; x < 4u; ++x) {
            float of_both = of_row * share(first.x + x, own.x, WIDTH, READ_WIDTH);
            if (of_both > 0.0) {
                sum += of_both * read_at(first + uvec2(x, y));
            }
        }
    }
    written[PLANE + pixel] = sum;
}
