// The depth behind which a pixel is saturated: that of the sample for it and three others. Where it
// is, the pixel is filled with the colour of what lies there, and the quads are blended over that:
// what the depth test leaves out is then replaced by something like it, not by nothing.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"
#include "common/saturation.glsl"

layout(set = 0, binding = 1) uniform UIMAGE_2D saturated;
layout(location = 0) out vec4 behind;

void main() {
    uint word = texelFetch(saturated, ivec2(gl_FragCoord.xy) / 2, 0).x;
    gl_FragDepth = saturated_depth(word);
    behind = word < NEVER_SATURATED ? vec4(saturated_color(word), 1.0) : vec4(0.0);
}
