// D-SSIM: 1 less the mean structural similarity of two pictures, and its derivative with respect to
// the weighted means around each pixel.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "perceptual/dssim.glsl"

// Derivatives with respect to the means of a, a² and ab, over the sum of the window's weights. Shape:
// 3 · 3 · height · width.
layout(std430, set = 0, binding = 2) writeonly buffer Written { float written[]; };
// What the pixels of each workgroup add to the distance.
layout(std430, set = 0, binding = 3) writeonly buffer Sums { float sums[]; };

shared float parts[TRAIN_WORKGROUP];

// The distance at a pixel.
float at_pixel(uint pixel) {
    uint first = gl_WorkGroupID.y * PLANE;
    uint target = (3u + gl_WorkGroupID.y) * PLANE;
    ivec2 own = ivec2(pixel % WIDTH, pixel / WIDTH);
    // Squares are of what differs from the middle: f32 holds small variances of light pixels so.
    vec2 middle = vec2(read_maps[first + pixel], read_maps[target + pixel]);
    float weights = 0.0;
    vec2 mean = vec2(0.0);
    vec2 square = vec2(0.0);
    float product = 0.0;
    for (int y = -RADIUS; y <= RADIUS; ++y) {
        for (int x = -RADIUS; x <= RADIUS; ++x) {
            ivec2 at = own + ivec2(x, y);
            if (is_inside(at)) {
                uint place = uint(at.y) * WIDTH + uint(at.x);
                vec2 both = vec2(read_maps[first + place], read_maps[target + place]) - middle;
                float share = weight(x, y);
                weights += share;
                mean += share * both;
                square += share * both * both;
                product += share * both.x * both.y;
            }
        }
    }
    float over_weights = 1.0 / weights;
    mean *= over_weights;
    vec2 variance = square * over_weights - mean * mean;
    float covariance = 2.0 * (product * over_weights - mean.x * mean.y) + C2;
    mean += middle;
    float means = 2.0 * mean.x * mean.y + C1;
    float squares = dot(mean, mean) + C1;
    float variances = variance.x + variance.y + C2;
    float over = 1.0 / (squares * variances);
    float ssim = means * covariance * over;
    // Over all pixels of three channels.
    float count = 3.0 * float(PLANE);
    float scale = -over_weights / count;
    uint place = first + pixel;
    written[place] = scale * 2.0
        * (mean.y * (covariance - means) * over + ssim * mean.x * (1.0 / variances - 1.0 / squares));
    written[3u * PLANE + place] = scale * -ssim / variances;
    written[6u * PLANE + place] = scale * 2.0 * means * over;
    return (1.0 - ssim) / count;
}

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint pixel = gl_GlobalInvocationID.x;
    parts[thread] = pixel < PLANE ? at_pixel(pixel) : 0.0;
    barrier();
    if (thread == 0u) {
        float sum = 0.0;
        for (uint k = 0u; k < gl_WorkGroupSize.x; ++k) {
            sum += parts[k];
        }
        sums[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sum;
    }
}
