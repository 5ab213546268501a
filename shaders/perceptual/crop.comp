// The part of a view that a loss sees, a plane a channel: of the image over what is behind the
// avatar, then of the picture. Where nothing is known of the picture it is as the image.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
// What colours of 0 to 1 are multiplied by, and what is taken away then.
layout(constant_id = 0) const float FACTOR_RED = 1.0;
layout(constant_id = 1) const float FACTOR_GREEN = 1.0;
layout(constant_id = 2) const float FACTOR_BLUE = 1.0;
layout(constant_id = 3) const float OFFSET_RED = 0.0;
layout(constant_id = 4) const float OFFSET_GREEN = 0.0;
layout(constant_id = 5) const float OFFSET_BLUE = 0.0;

layout(std430, set = 0, binding = 1) readonly buffer Image { vec4 image[]; };
layout(std430, set = 0, binding = 2) readonly buffer Pictures { uint pictures[]; };
layout(std430, set = 0, binding = 3) readonly buffer Behind { uint behind[]; };
// Shape: 2 · 3 · height · width.
layout(std430, set = 0, binding = 4) writeonly buffer Written { float written[]; };

void main() {
    uint at = gl_GlobalInvocationID.x;
    uint plane = block.window.z * block.window.w;
    if (at >= plane) {
        return;
    }
    uvec2 place = block.window.xy + uvec2(at % block.window.z, at / block.window.z);
    uint pixel = place.y * block.image_size.x + place.x;
    uint first = VIEW * block.image_size.x * block.image_size.y;
    vec4 drawn = image[pixel];
    vec4 shown = unpackUnorm4x8(pictures[first + pixel]);
    vec3 background = unpackUnorm4x8(behind[first + pixel]).xyz;
    vec3 own = clamp(block.gain.xyz * drawn.xyz + drawn.w * background, 0.0, 1.0);
    vec3 truth = shown.w > 0.1 ? shown.xyz : own;
    vec3 factor = vec3(FACTOR_RED, FACTOR_GREEN, FACTOR_BLUE);
    vec3 offset = vec3(OFFSET_RED, OFFSET_GREEN, OFFSET_BLUE);
    for (uint c = 0u; c < 3u; ++c) {
        written[c * plane + at] = factor[c] * own[c] - offset[c];
        written[(3u + c) * plane + at] = factor[c] * truth[c] - offset[c];
    }
}
