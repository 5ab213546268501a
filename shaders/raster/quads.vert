// The quad of a splat (model.md, step 10): its corners lie where the splat's opacity falls to the
// cutoff. QUADS_PER_INSTANCE quads an instance. GPUs that bin by tile run this twice, first for the
// position alone, so it is kept short.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/frame.glsl"
#include "common/splat.glsl"
#include "common/control.glsl"
#include "raster/quads.glsl"
#include "common/bins.glsl"

// Quads are at least as large as for this exponent, which is no less than CUTOFF_EXPONENT.
PARAMETER(1, float, QUAD_EXPONENT, -7.994353)
// Whether fragments are tested against the saturation depth, and only marked splats drawn.
PARAMETER(2, bool, DEPTH, false)

layout(std430, set = 0, binding = 1) readonly buffer Order { uint order[]; };
layout(std430, set = 0, binding = 2) readonly buffer Splats { uvec4 splats[]; };  // then the keys
layout(std430, set = 0, binding = 3) readonly buffer ControlBuffer { Control control; };
#include "common/key_at.glsl"
// Bound to anything where DEPTH is false.
#ifdef WEB
layout(std430, set = 0, binding = 4) readonly buffer Marks { uint marks[]; };
#else
layout(std430, set = 0, binding = 4) readonly buffer Bins { uint bins[]; };
#endif

// Whether some part of the image met the splat before it was saturated.
bool marked(uint i) { return (MARK_WORD(i >> 5u) >> (i & 31u) & 1u) != 0u; }

// Where in the quad, in standard deviations of √(2 ln 2): at most 3, so 16 bits suffice on a device
// that has such varyings.
layout(location = 0) out mediump vec2 offset;
// Red, green, blue and the exponent of the opacity, halves.
layout(location = 1) flat out uvec2 color;

void main() {
    uint quad = uint(gl_InstanceIndex) * QUADS_PER_INSTANCE + uint(gl_VertexIndex) / 4u;
    // All corners of a quad past the last splat fall on one point.
    gl_Position = vec4(-2.0, -2.0, 0.0, 1.0);
    if (quad >= control.visible_count) {
        return;
    }
    uint i = order[quad];
    if (DEPTH && !marked(i)) {
        return;
    }
    uvec4 words = splats[i];
    Splat splat = unpack_splat(words);
    float opacity = log2(float(splat.opacity) / 255.0);
    float radius = sqrt(max(opacity, QUAD_EXPONENT) - CUTOFF_EXPONENT);
    offset = vec2((gl_VertexIndex & 1) == 0 ? -radius : radius,
                  (gl_VertexIndex & 2) == 0 ? -radius : radius);
    vec2 across = vec2(-splat.axis.y, splat.axis.x) *
                  (inversesqrt(dot(splat.axis, splat.axis)) * splat.shorter);
    vec2 at = (fixed_center(words) - frame.clip.z) * coarseness_of(words) +
              frame.clip.w * (offset.x * splat.axis + offset.y * across);
    gl_Position.xy = at * frame.clip.xy - 1.0;
    if (DEPTH) {
        gl_Position.z = 1.0 - float(key_at(i)) / float(frame.key_max);
    }
    // Multiples of 1/2048 are exact in f16. Other numbers some devices round and some truncate.
    vec3 rounded = round(2048.0 * splat.color) / 2048.0;
    color = uvec2(packHalf2x16(rounded.rg), packHalf2x16(vec2(rounded.b, opacity)));
}
