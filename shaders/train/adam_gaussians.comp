// Adam of what is learned of each Gaussian but its bases. The derivative is the sum over the views.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Status { uint status[]; };
layout(std430, set = 0, binding = 2) readonly buffer OfGaussians { vec4 of_gaussians[]; };
layout(std430, set = 0, binding = 3) buffer Learned { vec4 learned[]; };
layout(std430, set = 0, binding = 4) buffer FirstMoments { vec4 first_moments[]; };
layout(std430, set = 0, binding = 5) buffer SecondMoments { vec4 second_moments[]; };
#include "train/gradient.glsl"
#include "train/adam.glsl"

void main() {
    uint g = gl_GlobalInvocationID.x;
    // A step whose pairs did not fit is repeated.
    if (g >= GAUSSIANS || status[0] > PAIR_CAPACITY) {
        return;
    }
    for (uint row = 0u; row < 3u; ++row) {
        vec4 gradient = vec4(0.0);
        for (uint view = 0u; view < VIEWS; ++view) {
            gradient += of_gaussians[gradient_at(view, g) + row];
        }
        uint at = 3u * g + row;
        vec4 value = learned[at], m = first_moments[at], v = second_moments[at];
        vec4 rate = row == 0u   ? vec4(block.rates_gaussian.x)
                    : row == 1u ? vec4(vec3(block.rates_gaussian.y), block.rates_gaussian.z)
                                : vec4(block.rates_gaussian.w);
        // The colour's fourth number is none, and its derivative holds signs.
        uint numbers = row == 2u ? 3u : 4u;
        for (uint c = 0u; c < numbers; ++c) {
            Moments moments = Moments(m[c], v[c]);
            value[c] = adam_step(value[c], gradient[c], rate[c], 0.0, block.adam_correction.xy, moments);
            m[c] = moments.m;
            v[c] = moments.v;
        }
        learned[at] = value;
        first_moments[at] = m;
        second_moments[at] = v;
    }
}
