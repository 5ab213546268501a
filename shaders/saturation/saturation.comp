// The saturation depth: at each sample, where four pixels meet, depth and colour of the splat with
// which it is saturated. A splat counts by its least opacity at the four, so that what lies further
// back shows by less than SATURATION at each. common/saturation.glsl has a sample's word.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
layout(set = 0, binding = 5, r32ui) writeonly uniform uimage2D saturated;
#define REGION SATURATION_REGION
#define STEP 2u
#define GROUP RASTER_WORKGROUP
#define MARKS
#include "raster/batches.glsl"

struct Samples {
    // How much of what lies behind shows.
    float light[4];
    // The word of the splat with which each sample was saturated; NEVER_SATURATED until then.
    uint word[4];
    bool open;
    uint evaluated;
};

void blend(inout Samples samples, Seen seen) {
    for (uint s = 0u; s < 4u; ++s) {
        float light = samples.light[s];
        float behind = light - light * seen.opacity[s];
        samples.word[s] = light >= SATURATION && behind < SATURATION ? seen.word : samples.word[s];
        samples.light[s] = behind;
    }
    samples.open = max(max(samples.light[0], samples.light[1]),
                       max(samples.light[2], samples.light[3])) >= SATURATION;
}

#include "raster/batches_main.glsl"

void store(uvec2 at, uint word) {
    if (all(lessThan(at, imageSize(saturated)))) {
        imageStore(saturated, ivec2(at), uvec4(word));
    }
}

void main() {
    uvec2 region = FIRST_REGION + gl_WorkGroupID.xy;
    uvec2 first = 2u * place_of(gl_LocalInvocationIndex);
    Samples samples;
    samples.open = true;
    samples.evaluated = 0u;
    samples.light = float[](1.0, 1.0, 1.0, 1.0);
    samples.word =
        uint[](NEVER_SATURATED, NEVER_SATURATED, NEVER_SATURATED, NEVER_SATURATED);
    blend_bin(samples, region * REGION, float(STEP) * (vec2(first) + 0.5));
    first += region * (REGION / STEP);
    store(first, samples.word[0]);
    store(first + uvec2(1u, 0u), samples.word[1]);
    store(first + uvec2(0u, 1u), samples.word[2]);
    store(first + uvec2(1u, 1u), samples.word[3]);
    if (COUNTED && samples.evaluated > 0u) {
        atomicAdd(control.fragments, samples.evaluated);
    }
}
