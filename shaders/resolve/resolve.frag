// The mean of the atlas over the area of a pixel, premultiplied.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"

layout(set = 0, binding = 0) uniform IMAGE_2D atlas;
#ifdef WEB
layout(std140, set = 0, binding = 1) uniform Slot {
#else
layout(push_constant) uniform Slot {
#endif
    // Column and row in the image of the first pixel that the slot holds.
    ivec2 shown;
    // Column and row in the atlas of its first texel.
    ivec2 first;
    // Texels of the atlas in a pixel, each way; need not be whole.
    float factor;
};
layout(location = 0) out vec4 result;

// A share of a texel up to this is what rounding leaves of none, px.
const float NONE = 1e-3;

void main() {
    vec2 pixel = vec2(ivec2(gl_FragCoord.xy) - shown);
    vec2 begin = factor * pixel;
    vec2 end = factor * (pixel + 1.0);
    vec4 sum = vec4(0.0);
    float area = 0.0;
    for (float y = floor(begin.y); y < end.y; y += 1.0) {
        float tall = min(end.y, y + 1.0) - max(begin.y, y);
        for (float x = floor(begin.x); x < end.x; x += 1.0) {
            float wide = min(end.x, x + 1.0) - max(begin.x, x);
            if (min(tall, wide) > NONE) {
                sum += tall * wide * texelFetch(atlas, first + ivec2(x, y), 0);
                area += tall * wide;
            }
        }
    }
    result = sum / area;
}
