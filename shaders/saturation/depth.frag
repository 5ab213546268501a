// The depth behind which a pixel is saturated: the furthest of the four samples around it. Where it
// is, the pixel is filled with the colour of what lies there, and the quads are blended over that:
// what the depth test leaves out is then replaced by something like it, not by nothing.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"
#include "common/saturation.glsl"

layout(set = 0, binding = 1) uniform UIMAGE_2D saturated;
layout(location = 0) out vec4 behind;

void main() {
#ifdef WEB
    // It is no sampled texture there: naga knows no sampler that is part of one.
    ivec2 last = textureSize(saturated, 0) - 1;
    ivec2 high = (ivec2(gl_FragCoord.xy) + 1) / 2;
    ivec2 low = max(high - 1, 0);
    high = min(high, last);
    uvec4 four = uvec4(texelFetch(saturated, low, 0).x,
                       texelFetch(saturated, ivec2(high.x, low.y), 0).x,
                       texelFetch(saturated, ivec2(low.x, high.y), 0).x,
                       texelFetch(saturated, high, 0).x);
#else
    vec2 at = gl_FragCoord.xy / (2.0 * vec2(textureSize(saturated, 0)));
    uvec4 four = textureGather(saturated, at);
#endif
    uint furthest = max(max(four.x, four.y), max(four.z, four.w));
    gl_FragDepth = saturated_depth(furthest);
    behind = furthest < NEVER_SATURATED ? vec4(saturated_color(furthest), 1.0) : vec4(0.0);
}
