// A bin's list, walked by a workgroup in batches of a splat an invocation: each invocation reads
// one, tests its ellipse against the workgroup's region, and leaves what meets it in shared memory,
// where all find it. For GPUs: `saturation` and the shared-memory kernel of `raster` are built on
// it. It needs no subgroups.
//
// The including shader declares what it writes before this file, and defines REGION, the side of
// the region that a workgroup draws, px; STEP, the distance of its samples, px; and MARKS if splats
// are marked and their keys needed. An invocation has 2 by 2 samples.
#include "common/platform.glsl"
#include "common/frame.glsl"
#include "common/splat.glsl"
#include "common/control.glsl"

layout(local_size_x = RASTER_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Splats { uvec4 splats[]; };  // then the keys
layout(std430, set = 0, binding = 2) buffer ControlBuffer { Control control; };
layout(std430, set = 0, binding = 3) readonly buffer Sorted { uint sorted[]; };
#if defined(MARKS) && !defined(WEB)
layout(std430, set = 0, binding = 4) buffer Bins { uint bins[]; };
#else
layout(std430, set = 0, binding = 4) readonly buffer Bins { uint bins[]; };
#endif
#if defined(MARKS) && defined(WEB)
layout(std430, set = 0, binding = 6) buffer Marks { uint marks[]; };
#endif
// Exponent of the opacity under which nothing is drawn.
PARAMETER(0, float, CUTOFF_EXPONENT, -7.994353)
// A sample is saturated if what lies behind would show by less than this.
PARAMETER(1, float, SATURATION, 1.0 / 255.0)
// Whether evaluated samples are counted.
PARAMETER(2, bool, COUNTED, false)
#include "common/bins.glsl"
#ifdef MARKS
#include "common/key_at.glsl"
#include "common/saturation.glsl"
#endif

// √(½ log₂ e): in standard deviations times this, a Gaussian is 2^−|deviation|².
const float DEVIATION_UNIT = 0.84932180;
// The ellipse test may be wrong by rounding: a splat is kept if it misses by less than this.
const float EXPONENT_SLACK = 1.0 / 256.0;

// The batch: of each splat the centre, in px from the region's corner; the matrix from px to
// deviations; the exponent of its opacity, and its colour, 10 bits a channel. With MARKS it has the
// splat's word (common/saturation.glsl) in place of the colour.
shared vec4 batch_place[RASTER_WORKGROUP];
shared vec4 batch_shape[RASTER_WORKGROUP];
#ifdef MARKS
// Whether an invocation that was not saturated came to the splat.
shared uint batch_seen[RASTER_WORKGROUP];
#endif
// A bit for each splat of the batch that meets a quarter of the region; a row of words a quarter.
const uint HIT_WORDS = RASTER_WORKGROUP / 32u;
shared uint batch_hits[4u * HIT_WORDS];
// Whether some invocation has a sample that is not saturated. It is no array: on WebGPU a read of it
// is one that all invocations make together (tools/shaders/wgsl.rs).
shared uint batch_open;

// A splat of the batch as an invocation sees it.
struct Seen {
    // Deviation at the first sample, and from a sample to the next.
    vec2 deviation;
    vec2 right;
    vec2 down;
    float exponent;
    uint word;
};

// Smallest |deviation|² in a rectangle, of a deviation whose square is a x² + 2 b x y + c y². `low`
// and `high`: the rectangle's corners as seen from the centre, px.
float nearest(float a, float b, float c, vec2 low, vec2 high) {
    // On the side that faces the centre, from the left or right and from above or below.
    vec2 side = clamp(vec2(0.0), low, high);
    vec2 p = vec2(side.x, clamp(-b * side.x / c, low.y, high.y));
    vec2 q = vec2(clamp(-b * side.y / a, low.x, high.x), side.y);
    return min(a * p.x * p.x + 2.0 * b * p.x * p.y + c * p.y * p.y,
               a * q.x * q.x + 2.0 * b * q.x * q.y + c * q.y * q.y);
}

// Puts a splat into the batch if it meets the region whose corner is at `corner`, px.
void load(uint thread, uint i, vec2 corner) {
    Splat splat = unpack_splat(splats[i]);
    float inverse = 1.0 / dot(splat.axis, splat.axis);
    vec2 along = DEVIATION_UNIT * inverse * splat.axis;
    vec2 across = DEVIATION_UNIT * sqrt(inverse) / splat.shorter *
                  vec2(-splat.axis.y, splat.axis.x);
    float exponent = log2(float(splat.opacity) / 255.0);
    vec2 center = splat.center - corner;
    float a = along.x * along.x + across.x * across.x;
    float b = along.x * along.y + across.x * across.y;
    float c = along.y * along.y + across.y * across.y;
    bool meets = false;
    // Unrolled, it takes more registers than blending.
    [[dont_unroll]] for (uint quarter = 0u; quarter < 4u; ++quarter) {
        const float side = 0.5 * float(REGION);
        vec2 low = side * vec2(quarter & 1u, quarter >> 1u) - center;
        vec2 high = low + side;
        low += 0.5 - MARGIN;
        high -= 0.5 - MARGIN;
        // Written so that a splat is kept where a number is NaN.
        if (!(nearest(a, b, c, low, high) > exponent - CUTOFF_EXPONENT + EXPONENT_SLACK)) {
            atomicOr(batch_hits[quarter * HIT_WORDS + (thread >> 5u)], 1u << (thread & 31u));
            meets = true;
        }
    }
    if (!meets) {
        return;
    }
#ifdef MARKS
    uint word = saturated_word(1.0 - float(key_at(i)) / float(frame.key_max), splat.color);
#else
    uvec3 color = uvec3(round(splat.color * 1023.0));
    uint word = color.r | color.g << 10u | color.b << 20u;
#endif
    batch_place[thread] = vec4(center, along);
    batch_shape[thread] = vec4(across, exponent, uintBitsToFloat(word));
}

// `first`: an invocation's first sample, px from the region's corner.
Seen see(uint k, vec2 first) {
    vec4 place = batch_place[k], shape = batch_shape[k];
    vec2 from = first - place.xy;
    Seen seen;
    seen.deviation = vec2(dot(from, place.zw), dot(from, shape.xy));
    seen.right = float(STEP) * vec2(place.z, shape.x);
    seen.down = float(STEP) * vec2(place.w, shape.y);
    seen.exponent = shape.z;
    seen.word = floatBitsToUint(shape.w);
    return seen;
}

// Opacity of a splat at a deviation; 0 under the cutoff.
float opacity_at(vec2 deviation, float exponent) {
    float power = exponent - dot(deviation, deviation);
    return power >= CUTOFF_EXPONENT ? min(ALPHA_MAX, exp2(power)) : 0.0;
}
