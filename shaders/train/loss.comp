// Stage loss of the training: L1 between the image over what is behind the avatar and the picture,
// where the picture's alpha says that something is known of it. Writes the derivative, and sums of
// a workgroup's rows.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Image { vec4 image[]; };
// RGBA8 of all views, one after the other.
layout(std430, set = 0, binding = 2) readonly buffer Pictures { uint pictures[]; };
// The same of what is behind the avatar.
layout(std430, set = 0, binding = 3) readonly buffer Behind { uint behind[]; };
// What other losses ask of the image over what is behind the avatar.
layout(std430, set = 0, binding = 4) readonly buffer Asked { vec4 asked[]; };
layout(std430, set = 0, binding = 5) writeonly buffer OfImage { vec4 of_image[]; };
// Of each workgroup of a view: the sum of |difference|, and of its square, of all channels; the
// derivative of the gain.
layout(std430, set = 0, binding = 6) writeonly buffer Sums { float loss_sums[]; };

shared vec2 sums[TRAIN_WORKGROUP];
shared vec3 of_gain[TRAIN_WORKGROUP];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint pixel = gl_GlobalInvocationID.x;
    uint pixels = block.image_size.x * block.image_size.y;
    sums[thread] = vec2(0.0);
    of_gain[thread] = vec3(0.0);
    if (pixel < pixels) {
        vec4 drawn = image[pixel];
        vec4 shown = unpackUnorm4x8(pictures[VIEW * pixels + pixel]);
        vec3 background = unpackUnorm4x8(behind[VIEW * pixels + pixel]).xyz;
        vec3 color = block.gain.xyz * drawn.xyz + drawn.w * background;
        vec3 of = block.loss_weights.w * asked[pixel].xyz;
        if (shown.w > 0.1) {
            vec3 difference = clamp(color, 0.0, 1.0) - shown.xyz;
            sums[thread] = vec2(dot(abs(difference), vec3(1.0)), dot(difference, difference));
            of += block.loss_weights.x * sign(difference);
        }
        // Beyond what an image holds there is no difference.
        of *= vec3(greaterThanEqual(color, vec3(0.0))) * vec3(lessThanEqual(color, vec3(1.0)));
        of_gain[thread] = of * drawn.xyz;
        of_image[pixel] = vec4(block.gain.xyz * of, dot(of, background));
    }
    barrier();
    if (thread == 0u) {
        vec2 sum = vec2(0.0);
        vec3 gain = vec3(0.0);
        for (uint k = 0u; k < TRAIN_WORKGROUP; ++k) {
            sum += sums[k];
            gain += of_gain[k];
        }
        uint at = TRAIN_LOSS_SUMS * (VIEW * gl_NumWorkGroups.x + gl_WorkGroupID.x);
        loss_sums[at] = sum.x;
        loss_sums[at + 1u] = sum.y;
        loss_sums[at + 2u] = gain.x;
        loss_sums[at + 3u] = gain.y;
        loss_sums[at + 4u] = gain.z;
    }
}
