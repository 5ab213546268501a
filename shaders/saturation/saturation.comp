// The saturation depth: at each sample, which is the corner of four pixels, the depth of the splat
// with which the sample is saturated. What lies further back shows by less than SATURATION there.
// Every second pixel has a sample in x and y. Depth is 1 less the key that splats are sorted by, as
// the quads have it; 1 where a sample is never saturated.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
layout(set = 0, binding = 5, r32f) writeonly uniform image2D depths;
#define REGION SATURATION_REGION
#define STEP 2u
#define MARKS
#include "raster/batches.glsl"

struct Samples {
    // How much of what lies behind shows.
    float light[4];
    // The key with which each sample was saturated; 0, the furthest, until then.
    uint key[4];
    bool open;
    uint evaluated;
};

void blend_sample(inout float light, inout uint key, vec2 deviation, float exponent, uint own) {
    float behind = light - light * opacity_at(deviation, exponent);
    key = light >= SATURATION && behind < SATURATION ? own : key;
    light = behind;
}

void blend(inout Samples samples, uint k, vec2 first) {
    Seen seen = see(k, first);
    uint own = batch_key[k];
    vec2 right = seen.deviation + seen.right;
    blend_sample(samples.light[0], samples.key[0], seen.deviation, seen.exponent, own);
    blend_sample(samples.light[1], samples.key[1], right, seen.exponent, own);
    blend_sample(samples.light[2], samples.key[2], seen.deviation + seen.down, seen.exponent, own);
    blend_sample(samples.light[3], samples.key[3], right + seen.down, seen.exponent, own);
    samples.open = max(max(samples.light[0], samples.light[1]),
                       max(samples.light[2], samples.light[3])) >= SATURATION;
    samples.evaluated += 4u;
}

#include "raster/batches_main.glsl"

// A step of the 16-bit depth test further than the key says, so that rounding culls nothing.
float depth_of(uint key) {
    return min(1.0 - float(key) / float(frame.key_max) + 1.0 / 65535.0, 1.0);
}

void store(uvec2 at, uint key) {
    if (all(lessThan(at, imageSize(depths)))) {
        imageStore(depths, ivec2(at), vec4(depth_of(key)));
    }
}

void main() {
    uvec2 region = FIRST_REGION + gl_WorkGroupID.xy;
    uvec2 first = 2u * place_of(gl_LocalInvocationIndex);
    Samples samples;
    samples.open = true;
    samples.evaluated = 0u;
    samples.light = float[](1.0, 1.0, 1.0, 1.0);
    samples.key = uint[](0u, 0u, 0u, 0u);
    blend_bin(samples, region * REGION, float(STEP) * (vec2(first) + 0.5));
    first += region * (REGION / STEP);
    store(first, samples.key[0]);
    store(first + uvec2(1u, 0u), samples.key[1]);
    store(first + uvec2(0u, 1u), samples.key[2]);
    store(first + uvec2(1u, 1u), samples.key[3]);
    if (COUNTED && samples.evaluated > 0u) {
        atomicAdd(control.fragments, samples.evaluated);
    }
}
