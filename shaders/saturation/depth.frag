// The depth behind which a pixel is saturated: the furthest of the four samples around it.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"

layout(set = 0, binding = 1) uniform IMAGE_2D depths;

void main() {
#ifdef WEB
    // It is no sampled texture there: naga knows no sampler that is part of one.
    ivec2 last = textureSize(depths, 0) - 1;
    ivec2 high = (ivec2(gl_FragCoord.xy) + 1) / 2;
    ivec2 low = max(high - 1, 0);
    high = min(high, last);
    vec4 four = vec4(texelFetch(depths, low, 0).x, texelFetch(depths, ivec2(high.x, low.y), 0).x,
                     texelFetch(depths, ivec2(low.x, high.y), 0).x,
                     texelFetch(depths, high, 0).x);
#else
    vec2 at = gl_FragCoord.xy / (2.0 * vec2(textureSize(depths, 0)));
    vec4 four = textureGather(depths, at);
#endif
    gl_FragDepth = max(max(four.x, four.y), max(four.z, four.w));
}
