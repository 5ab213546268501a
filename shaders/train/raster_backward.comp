// The derivative of stage raster, nearest first like the stage itself: with T the light before a
// splat, s its colour times the pixel's derivative and `behind` the same of all behind it,
// ∂α = T s − behind / (1 − α). Each pair gets a record of its own, summed over the tile's pixels in
// a fixed order through shared memory: no atomics, no subgroups, the same bits on every run.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "train/block.glsl"
#include "train/raster.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Ranges { uint ranges[]; };
layout(std430, set = 0, binding = 2) readonly buffer PairOrder { uint pair_order[]; };
layout(std430, set = 0, binding = 3) readonly buffer PairGaussians { uint pair_gaussians[]; };
layout(std430, set = 0, binding = 4) readonly buffer Splats { vec4 splats[]; };
layout(std430, set = 0, binding = 5) readonly buffer Image { vec4 image[]; };
// Of the loss with respect to the image over its background; w: times that background.
layout(std430, set = 0, binding = 6) readonly buffer OfImage { vec4 of_image[]; };
layout(std430, set = 0, binding = 7) writeonly buffer Records { float records[]; };

shared float parts[BATCH * TRAIN_RECORD * gl_WorkGroupSize.x];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint width = gl_WorkGroupSize.x;
    uint tile = gl_WorkGroupID.y * block.image_size.z + gl_WorkGroupID.x;
    uint column = gl_WorkGroupID.x * TILE + thread % TILE;
    uint row = (block.band.x + gl_WorkGroupID.y) * TILE + thread / TILE;
    vec2 first = vec2(column, row) + 0.5;
    // Of each pixel: the derivative of its colour, what is still behind, and the light left.
    vec3 of_pixel[PIXELS];
    float behind[PIXELS];
    float light[PIXELS];
    for (uint p = 0u; p < PIXELS; ++p) {
        uint y = row + p * STEP;
        of_pixel[p] = vec3(0.0);
        behind[p] = 0.0;
        light[p] = 0.0;
        if (column < block.image_size.x && y < block.image_size.y) {
            uint at = y * block.image_size.x + column;
            vec4 of = of_image[at];
            vec4 pixel = image[at];
            of_pixel[p] = of.xyz;
            behind[p] = dot(of.xyz, pixel.xyz) + of.w * pixel.w;
            light[p] = 1.0;
        }
    }
    uint end = ranges[tile + 1u];
    uint start = ranges[tile];
    for (; start < end; start += BATCH) {
        bool open = false;
        for (uint p = 0u; p < PIXELS; ++p) {
            open = open || light[p] >= FULL;
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
        uint count = min(BATCH, end - start);
        for (uint k = 0u; k < count; ++k) {
            uint splat = 3u * pair_gaussians[pair_order[start + k]];
            vec4 center_radius = splats[splat];
            vec4 shape = splats[splat + 1u];
            vec3 color = splats[splat + 2u].xyz;
            float dx = first.x - center_radius.x;
            uvec2 rows = abs(dx) > center_radius.z ? uvec2(0u) : rows_of(center_radius, first.y - 0.5);
            vec3 of_color = vec3(0.0);
            float of_power = 0.0, of_power_y = 0.0, of_power_yy = 0.0;
            [[unroll]] for (uint p = 0u; p < PIXELS; ++p) {
                float dy = first.y + float(p * STEP) - center_radius.y;
                float raw = alpha_at(shape, vec2(dx, dy));
                if (p >= rows.x && p < rows.y && raw >= 1.0 / 255.0 && light[p] >= FULL) {
                    float alpha = min(raw, ALPHA_MAX);
                    float weight = alpha * light[p];
                    float shine = dot(color, of_pixel[p]);
                    of_color += weight * of_pixel[p];
                    behind[p] -= weight * shine;
                    float of_alpha = light[p] * shine - behind[p] / (1.0 - alpha);
                    light[p] *= 1.0 - alpha;
                    if (raw < ALPHA_MAX) {
                        float of = of_alpha * alpha;
                        of_power += of;
                        of_power_y += of * dy;
                        of_power_yy += of * dy * dy;
                    }
                }
            }
            uint at = TRAIN_RECORD * width * k + thread;
            parts[at] = of_color.x;
            parts[at + width] = of_color.y;
            parts[at + 2u * width] = of_color.z;
            parts[at + 3u * width] = of_power;
            parts[at + 4u * width] = shape.x * dx * of_power + shape.y * of_power_y;
            parts[at + 5u * width] = shape.y * dx * of_power + shape.z * of_power_y;
            parts[at + 6u * width] = -0.5 * dx * dx * of_power;
            parts[at + 7u * width] = -dx * of_power_y;
            parts[at + 8u * width] = -0.5 * of_power_yy;
        }
        barrier();
        for (uint at = thread; at < TRAIN_RECORD * count; at += width) {
            float sum = 0.0;
            for (uint lane = 0u; lane < width; ++lane) {
                sum += parts[at * width + lane];
            }
            uint pair = pair_order[start + at / TRAIN_RECORD];
            uint number = at % TRAIN_RECORD;
            // The opacity's: α is proportional to it.
            if (number == 3u) {
                sum /= splats[3u * pair_gaussians[pair] + 1u].w;
            }
            records[TRAIN_RECORD * pair + number] = sum;
        }
    }
    // What lies behind full pixels has no part in them.
    barrier();
    for (uint at = TRAIN_RECORD * start + thread; at < TRAIN_RECORD * end; at += width) {
        records[TRAIN_RECORD * pair_order[at / TRAIN_RECORD] + at % TRAIN_RECORD] = 0.0;
    }
}
