// A bin's list, walked by a workgroup in batches of a splat an invocation: each invocation reads
// one, tests its ellipse against the region's parts, and leaves what meets some in shared memory,
// where all find it. For GPUs: `saturation` and the shared-memory kernel of `raster` are built on
// it. It needs no subgroups.
//
// The including shader declares what it writes before this file, and defines REGION, the side of
// the region that a workgroup draws, px; STEP, the distance of its samples, px; GROUP, its
// invocations, which have 2 by 2 samples each; and MARKS if splats are marked, their keys needed,
// and a sample stands for the four pixels around it.
#include "common/platform.glsl"
#include "common/frame.glsl"
#include "common/splat.glsl"
#include "common/control.glsl"

layout(local_size_x = GROUP) in;
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
// Whether samples of splats that show are counted.
PARAMETER(2, bool, COUNTED, false)
#include "common/bins.glsl"
#include "raster/place.glsl"
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
shared vec4 batch_place[GROUP];
shared vec4 batch_shape[GROUP];
#ifdef MARKS
// Whether an invocation that was not saturated came to the splat.
shared uint batch_seen[GROUP];
#endif
// Whether some invocation has a sample that is not saturated. It is no array: on WebGPU a read of it
// is one that all invocations make together (tools/shaders/wgsl.rs).
shared uint batch_open;

// A splat of the batch as an invocation sees it.
struct Seen {
    // At the first sample, the one to its right, and the two below; 0 under the cutoff. With MARKS
    // the least at the four pixels around each.
    vec4 opacity;
    uint word;
};

// Where a splat shows: a x² + 2 b x y + c y² is |deviation|², and `most` at its edge.
struct Ellipse {
    // Px from the region's corner.
    vec2 center;
    float a;
    float b;
    float c;
    // a c − b², without cancellation.
    float determinant;
    float most;
};

#include "raster/hits.glsl"

// Puts splat `i`, which is `packed`, into the batch if it meets the region whose corner is at
// `corner`, px.
void load(uint thread, uint i, uvec4 packed, vec2 corner) {
    Splat splat = unpack_splat(packed);
    float inverse = 1.0 / dot(splat.axis, splat.axis);
    vec2 along = DEVIATION_UNIT * inverse * splat.axis;
    vec2 across = DEVIATION_UNIT * sqrt(inverse) / splat.shorter *
                  vec2(-splat.axis.y, splat.axis.x);
    float exponent = log2(float(splat.opacity) / 255.0);
    Ellipse ellipse;
    ellipse.center = splat.center - corner;
    ellipse.a = along.x * along.x + across.x * across.x;
    ellipse.b = along.x * along.y + across.x * across.y;
    ellipse.c = along.y * along.y + across.y * across.y;
    ellipse.determinant = dot(along, along) * dot(across, across);
    ellipse.most = exponent - CUTOFF_EXPONENT + EXPONENT_SLACK;
    if (ellipse.most < 0.0 || !note_hits(thread, ellipse)) {
        return;
    }
#ifdef MARKS
    uint word = saturated_word(1.0 - float(key_at(i)) / float(frame.key_max), splat.color);
#else
    uvec3 color = uvec3(round(splat.color * 1023.0));
    uint word = color.r | color.g << 10u | color.b << 20u;
#endif
    batch_place[thread] = vec4(ellipse.center, along);
    batch_shape[thread] = vec4(across, exponent, uintBitsToFloat(word));
}

// Opacity of a splat at a deviation; 0 under the cutoff. With MARKS the least at the four pixels
// around a sample: the square of the distance to each is |deviation|² ± 2 deviation · step + |step|².
// `right` and `down`: a px, in deviations.
float opacity_at(vec2 deviation, float exponent, vec2 right, vec2 down) {
    float power = exponent - dot(deviation, deviation);
#ifdef MARKS
    vec2 below = 0.5 * (right + down), above = 0.5 * (right - down);
    power -= max(2.0 * abs(dot(deviation, below)) + dot(below, below),
                 2.0 * abs(dot(deviation, above)) + dot(above, above));
#endif
    return power >= CUTOFF_EXPONENT ? min(ALPHA_MAX, exp2(power)) : 0.0;
}

// `first`: an invocation's first sample, px from the region's corner.
Seen see(uint k, vec2 first) {
    vec4 place = batch_place[k], shape = batch_shape[k];
    vec2 from = first - place.xy;
    vec2 deviation = vec2(dot(from, place.zw), dot(from, shape.xy));
    vec2 right = vec2(place.z, shape.x), down = vec2(place.w, shape.y);
    vec2 second = deviation + float(STEP) * right;
    vec2 below = float(STEP) * down;
    Seen seen;
    seen.opacity = vec4(opacity_at(deviation, shape.z, right, down),
                        opacity_at(second, shape.z, right, down),
                        opacity_at(deviation + below, shape.z, right, down),
                        opacity_at(second + below, shape.z, right, down));
    seen.word = floatBitsToUint(shape.w);
    return seen;
}
