// Stage raster of the training (model.md, step 10): blends each tile's splats, nearest first, until
// its pixels are full. Writes premultiplied RGB, and what light comes through.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "train/block.glsl"
#include "train/raster.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Ranges { uint ranges[]; };
layout(std430, set = 0, binding = 2) readonly buffer PairOrder { uint pair_order[]; };
layout(std430, set = 0, binding = 3) readonly buffer PairGaussians { uint pair_gaussians[]; };
layout(std430, set = 0, binding = 4) readonly buffer Splats { vec4 splats[]; };
layout(std430, set = 0, binding = 5) writeonly buffer Image { vec4 image[]; };

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint tile = gl_WorkGroupID.y * block.image_size.z + gl_WorkGroupID.x;
    uint column = gl_WorkGroupID.x * TILE + thread % TILE;
    uint row = (block.band.x + gl_WorkGroupID.y) * TILE + thread / TILE;
    vec2 first = vec2(column, row) + 0.5;
    vec4 pixels[PIXELS];
    for (uint p = 0u; p < PIXELS; ++p) {
        pixels[p] = vec4(0.0, 0.0, 0.0, 1.0);
    }
    uint end = ranges[tile + 1u];
    for (uint start = ranges[tile]; start < end; start += BATCH) {
        bool open = false;
        for (uint p = 0u; p < PIXELS; ++p) {
            open = open || pixels[p].w >= FULL;
        }
        barrier();
        is_open = 0u;
        barrier();
        if (open) {
            is_open = 1u;
        }
        barrier();
        if (is_open == 0u) {
            break;
        }
        for (uint at = start; at < min(start + BATCH, end); ++at) {
            uint splat = 3u * pair_gaussians[pair_order[at]];
            vec4 center_radius = splats[splat];
            vec4 shape = splats[splat + 1u];
            vec3 color = splats[splat + 2u].xyz;
            float dx = first.x - center_radius.x;
            if (abs(dx) > center_radius.z) {
                continue;
            }
            uvec2 rows = rows_of(center_radius, first.y - 0.5);
            [[unroll]] for (uint p = 0u; p < PIXELS; ++p) {
                float alpha = alpha_at(shape, vec2(dx, first.y + float(p * STEP) - center_radius.y));
                if (p >= rows.x && p < rows.y && alpha >= 1.0 / 255.0 && pixels[p].w >= FULL) {
                    alpha = min(alpha, ALPHA_MAX);
                    pixels[p].xyz += alpha * pixels[p].w * color;
                    pixels[p].w *= 1.0 - alpha;
                }
            }
        }
    }
    for (uint p = 0u; p < PIXELS; ++p) {
        uint y = row + p * STEP;
        if (column < block.image_size.x && y < block.image_size.y) {
            image[y * block.image_size.x + column] = pixels[p];
        }
    }
}
