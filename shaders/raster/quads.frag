// A fragment of a splat (model.md, step 10): its colour and opacity, which the blender puts "over"
// what lies behind.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "raster/quads.glsl"

EARLY_FRAGMENT_TESTS
layout(location = 0) in mediump vec2 offset;
layout(location = 1) flat in uvec2 color;
layout(location = 0) out vec4 result;

void main() {
    vec2 red_green = unpackHalf2x16(color.x), blue_opacity = unpackHalf2x16(color.y);
    float exponent = blue_opacity.y - dot(offset, offset);
    if (exponent < CUTOFF_EXPONENT) {
        discard;
    }
    result = vec4(red_green, blue_opacity.x, min(ALPHA_MAX, exp2(exponent)));
}
