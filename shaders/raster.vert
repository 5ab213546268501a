// The quad of a splat (model.md, step 10): its corners lie where the splat's opacity falls to the cutoff. RASTER_QUADS quads an instance.
// Tilers run this twice, without the colour at first, so that it is kept short.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "layout.glsl"
#include "splat.glsl"
#include "sort_control.glsl"
#include "hulls.glsl"

// Hulls reach as far as for at least this exponent, which is no less than LEAST.
#ifdef WEB
#define HULL settings.hull
#else
layout(constant_id = 1) const float HULL = -7.994353;
#endif
// Whether fragments are tested against a depth surface.
#ifndef DEPTH
layout(constant_id = 2) const bool DEPTH = false;
#endif

layout(std430, set = 0, binding = 1) readonly buffer Order { uint order[]; };
layout(std430, set = 0, binding = 2) readonly buffer Splats { uvec4 splats[]; };  // then the keys
layout(std430, set = 0, binding = 3) readonly buffer ControlBuffer { Control control; };

// Where in the quad, in standard deviations of √(2 ln 2): at most 3, so that 16 bits do where a device has such varyings.
layout(location = 0) out mediump vec2 offset;
// Red, green, blue and the exponent of the opacity, halves.
layout(location = 1) flat out uvec2 color;

void main() {
    uint quad = uint(gl_InstanceIndex) * RASTER_QUADS + uint(gl_VertexIndex) / 4u;
    // All corners of a quad past the last splat fall on one point.
    gl_Position = vec4(-2.0, -2.0, 0.0, 1.0);
    if (quad >= control.survivors) {
        return;
    }
    uint i = order[quad];
    uvec4 words = splats[i];
    Splat splat = unpack_splat(words);
    float opacity = log2(float(splat.opacity) / 255.0);
    float reach = sqrt(max(opacity, HULL) - LEAST);
    offset = vec2((gl_VertexIndex & 1) == 0 ? -reach : reach, (gl_VertexIndex & 2) == 0 ? -reach : reach);
    vec2 across = vec2(-splat.axis.y, splat.axis.x) * (inversesqrt(dot(splat.axis, splat.axis)) * splat.shorter);
    vec2 at = steps_of(words) - frame.clip.z + frame.clip.w * (offset.x * splat.axis + offset.y * across);
    gl_Position.xy = at * frame.clip.xy - 1.0;
    if (DEPTH) {
        uint key_at = frame.key_start + (frame.half_keys > 0u ? i / 2u : i);
        uint key = splats[key_at / 4u][key_at & 3u];
        key = frame.half_keys > 0u ? key >> 16u * (i & 1u) & 0xffffu : key;
        gl_Position.z = 1.0 - float(key) / float(frame.key_max);
    }
    // Multiples of 1/2048 are halves whichever way a device rounds; some cut off.
    vec3 rounded = round(2048.0 * splat.color) / 2048.0;
    color = uvec2(packHalf2x16(rounded.rg), packHalf2x16(vec2(rounded.b, opacity)));
}
