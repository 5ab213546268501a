// What a loss of a part of a view asks of each of the view's pixels, and its sums.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
// What colours of 0 to 1 were multiplied by.
layout(constant_id = 0) const float FACTOR_RED = 1.0;
layout(constant_id = 1) const float FACTOR_GREEN = 1.0;
layout(constant_id = 2) const float FACTOR_BLUE = 1.0;
// Sums of a view.
layout(constant_id = 3) const uint SUMS = 1u;

layout(std430, set = 0, binding = 1) readonly buffer Pictures { uint pictures[]; };
// The loss's derivative. Shape: 3 · height · width of the part.
layout(std430, set = 0, binding = 2) readonly buffer Read { float read_maps[]; };
layout(std430, set = 0, binding = 3) readonly buffer Sums { float sums[]; };
layout(std430, set = 0, binding = 4) writeonly buffer Asked { vec4 asked[]; };
// Of all views.
layout(std430, set = 0, binding = 5) writeonly buffer ViewSums { float view_sums[]; };

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel < SUMS) {
        view_sums[VIEW * SUMS + pixel] = sums[pixel];
    }
    uint pixels = block.image_size.x * block.image_size.y;
    if (pixel >= pixels) {
        return;
    }
    // Wraps around before the part's first column and row.
    uvec2 inside = uvec2(pixel % block.image_size.x, pixel / block.image_size.x) - block.window.xy;
    vec3 slope = vec3(0.0);
    bool is_known = unpackUnorm4x8(pictures[VIEW * pixels + pixel]).w > 0.1;
    if (is_known && all(lessThan(inside, block.window.zw))) {
        uint plane = block.window.z * block.window.w;
        uint at = inside.y * block.window.z + inside.x;
        vec3 factor = vec3(FACTOR_RED, FACTOR_GREEN, FACTOR_BLUE);
        slope = factor * vec3(read_maps[at], read_maps[plane + at], read_maps[2u * plane + at]);
    }
    asked[pixel] = vec4(slope, 0.0);
}
