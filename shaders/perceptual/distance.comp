// How far a layer's features of a picture are from those of its target, and the derivative: of a
// length of 1 at each pixel, squared differences weighted by channel, the mean over pixels. Features
// are rectified: where one is 0 the derivative with respect to what it was before is 0 too.
//
// Invocations of a column share a pixel, each with every so many of its channels.
#version 450
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = TRAIN_WORKGROUP) in;
layout(constant_id = 0) const uint CHANNELS = 1u;
// Pixels.
layout(constant_id = 1) const uint PLANE = 1u;
// Pixels of a workgroup.
layout(constant_id = 2) const uint PIXELS = 16u;
// 1: the derivative is added to what is there.
layout(constant_id = 3) const uint ADDS = 0u;
// Where the layer's sums begin.
layout(constant_id = 4) const uint FIRST = 0u;

// Of the picture, then of the target. Shape: 2 · channels · pixels.
layout(std430, set = 0, binding = 1) readonly buffer Read { float read_maps[]; };
layout(std430, set = 0, binding = 2) readonly buffer Weights { float weights[]; };
layout(std430, set = 0, binding = 3) buffer Written { float written[]; };
// What the pixels of each workgroup add to the distance.
layout(std430, set = 0, binding = 4) writeonly buffer Sums { float sums[]; };

const uint SLICES = gl_WorkGroupSize.x / PIXELS;
// Added to lengths.
const float EPSILON = 1e-10;

shared vec2 parts[TRAIN_WORKGROUP];

// The sum over the invocations of a pixel.
vec2 of_pixel(uint thread, vec2 own) {
    barrier();
    parts[thread] = own;
    barrier();
    vec2 sum = vec2(0.0);
    for (uint slice = 0u; slice < SLICES; ++slice) {
        sum += parts[slice * PIXELS + thread % PIXELS];
    }
    return sum;
}

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint pixel = gl_WorkGroupID.x * PIXELS + thread % PIXELS;
    // Beyond the last pixel there is no channel.
    uint channels = pixel < PLANE ? CHANNELS : 0u;
    uint first = thread / PIXELS;
    vec2 squares = vec2(0.0);
    for (uint channel = first; channel < channels; channel += SLICES) {
        float ours = read_maps[channel * PLANE + pixel];
        float theirs = read_maps[(CHANNELS + channel) * PLANE + pixel];
        squares += vec2(ours * ours, theirs * theirs);
    }
    vec2 over = 1.0 / (sqrt(of_pixel(thread, squares)) + EPSILON);

    // What the pixel adds to the distance, and its features times the distance's derivative with
    // respect to those of length 1.
    vec2 own = vec2(0.0);
    for (uint channel = first; channel < channels; channel += SLICES) {
        float ours = read_maps[channel * PLANE + pixel];
        float theirs = read_maps[(CHANNELS + channel) * PLANE + pixel] * over.y;
        float difference = ours * over.x - theirs;
        own += weights[channel] * difference * vec2(difference, ours);
    }
    vec2 both = of_pixel(thread, own);
    float along = both.y * over.x * over.x * over.x;
    float mean = 1.0 / float(PLANE);
    for (uint channel = first; channel < channels; channel += SLICES) {
        uint place = channel * PLANE + pixel;
        float ours = read_maps[place];
        float theirs = read_maps[CHANNELS * PLANE + place] * over.y;
        float slope = 2.0 * mean * (weights[channel] * (ours * over.x - theirs) * over.x - ours * along);
        if (ADDS == 1u) {
            slope += written[place];
        }
        written[place] = ours > 0.0 ? slope : 0.0;
    }
    barrier();
    parts[thread] = both;
    barrier();
    if (thread == 0u) {
        float sum = 0.0;
        for (uint k = 0u; k < PIXELS; ++k) {
            sum += parts[k].x;
        }
        sums[FIRST + gl_WorkGroupID.x] = mean * sum;
    }
}
