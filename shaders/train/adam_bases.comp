// Adam of the attributes' basis rows. Their derivative, the sum over the views of that of the
// correctives times the features, is never stored. An invocation has a column of a Gaussian's rows.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "train/block.glsl"

layout(local_size_x = TRAIN_BASES_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Status { uint status[]; };
layout(std430, set = 0, binding = 2) readonly buffer OfGaussians { vec4 of_gaussians[]; };
layout(std430, set = 0, binding = 3) readonly buffer Activations { float activations[]; };
layout(std430, set = 0, binding = 4) readonly buffer Rows { uvec4 rows[]; };
layout(std430, set = 0, binding = 5) buffer Bases { float bases[]; };
layout(std430, set = 0, binding = 6) buffer FirstMoments { float first_moments[]; };
layout(std430, set = 0, binding = 7) buffer SecondMoments { float second_moments[]; };
#include "train/features.glsl"
#include "train/gradient.glsl"
#include "train/corrective.glsl"
#include "train/adam.glsl"

void update(uint at, float gradient, float rate) {
    Moments moments = Moments(first_moments[at], second_moments[at]);
    bases[at] = adam_step(bases[at], gradient, rate, 0.0, block.adam_correction.zw, moments);
    first_moments[at] = moments.m;
    second_moments[at] = moments.v;
}

void main() {
    uint g = gl_GlobalInvocationID.x / TRAIN_BASIS;
    uint k = gl_GlobalInvocationID.x % TRAIN_BASIS;
    if (g >= GAUSSIANS || status[0] > PAIR_CAPACITY || !HAS_CORRECTIVES) {
        return;
    }
    uvec4 own = rows[g];
    vec4 rotation = vec4(0.0);
    vec3 scale = vec3(0.0), color = vec3(0.0);
    for (uint view = 0u; view < VIEWS; ++view) {
        uint at = gradient_at(view, g);
        vec4 color_signs = of_gaussians[at + 2u];
        uint signs = floatBitsToUint(color_signs.w);
        float feature = activations[features_at(view, own.w) + k];
        rotation += feature * of_rotation(of_gaussians[at], signs);
        scale += feature * of_scale(of_gaussians[at + 1u].xyz, signs);
        color += feature * of_color(color_signs.xyz, signs);
    }
    if (own.x != TRAIN_NO_ROW) {
        for (uint c = 0u; c < 4u; ++c) {
            update((4u * own.x + c) * TRAIN_BASIS + k, rotation[c], block.rates_bases.x);
        }
    }
    if (own.y != TRAIN_NO_ROW) {
        for (uint c = 0u; c < 3u; ++c) {
            uint at = block.network.z + (3u * own.y + c) * TRAIN_BASIS + k;
            update(at, scale[c], block.rates_bases.y);
        }
    }
    if (own.z != TRAIN_NO_ROW) {
        for (uint c = 0u; c < 3u; ++c) {
            uint at = block.network.w + (3u * own.z + c) * TRAIN_BASIS + k;
            update(at, color[c], block.rates_bases.z);
        }
    }
}
