// The tile rasterizer for GPUs: a workgroup draws a region, an invocation 2 by 2 px, from the list
// of the bin that the region lies in (batches.glsl).
#define REGION SHARED_REGION
#define STEP 1u
#define GROUP SHARED_WORKGROUP
#include "raster/batches.glsl"
#include "raster/filled.glsl"

struct Samples {
    // Colour, in 1023rds, and how much of what lies behind shows.
    vec4 pixels[4];
    bool open;
    uint evaluated;
};

void blend(inout Samples samples, Seen seen) {
    vec3 color = vec3(seen.word & 1023u, seen.word >> 10u & 1023u, seen.word >> 20u);
    for (uint p = 0u; p < 4u; ++p) {
        vec4 pixel = samples.pixels[p];
        float share = seen.opacity[p] * pixel.a;
        samples.pixels[p] = vec4(pixel.rgb + share * color, pixel.a - share);
    }
    samples.open = max(max(samples.pixels[0].a, samples.pixels[1].a),
                       max(samples.pixels[2].a, samples.pixels[3].a)) >= SATURATION;
}

#include "raster/batches_main.glsl"

void store(uvec2 at, vec4 pixel, bool open) {
    if (all(lessThan(at, uvec2(frame.size)))) {
        pixel = filled(pixel, open);
        imageStore(image, ivec2(at), vec4(pixel.rgb / 1023.0, pixel.a));
    }
}

void main() {
    uvec2 corner = (FIRST_REGION + gl_WorkGroupID.xy) * REGION;
    uvec2 first = 2u * place_of(gl_LocalInvocationIndex);
    Samples samples;
    bool drawn = is_drawn(corner);
    samples.open = drawn;
    samples.evaluated = 0u;
    const vec4 clear = vec4(0.0, 0.0, 0.0, 1.0);
    samples.pixels = vec4[](clear, clear, clear, clear);
    blend_bin(samples, corner, vec2(first) + 0.5);
    samples.open = samples.open || !drawn;
    first += corner;
    store(first, samples.pixels[0], samples.open);
    store(first + uvec2(1u, 0u), samples.pixels[1], samples.open);
    store(first + uvec2(0u, 1u), samples.pixels[2], samples.open);
    store(first + uvec2(1u, 1u), samples.pixels[3], samples.open);
    if (COUNTED && samples.evaluated > 0u) {
        atomicAdd(control.fragments, samples.evaluated);
    }
}
