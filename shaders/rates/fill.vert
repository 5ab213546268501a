// Quads side by side that cover the image, a layer an instance.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "rates/fill.glsl"

// Where in the quad, in standard deviations of √(2 ln 2).
layout(location = 0) out mediump vec2 offset;
layout(location = 1) flat out uint layer;

void main() {
    uint quad = uint(gl_VertexIndex) / 6u, corner = uint(gl_VertexIndex) % 6u;
    // Two triangles: 0 1 2 and 2 1 3.
    corner = corner < 3u ? corner : corner == 3u ? 2u : corner == 4u ? 1u : 3u;
    uvec2 side = uvec2(corner & 1u, corner >> 1u);
    vec2 at = vec2(uvec2(quad % COLUMNS, quad / COLUMNS) + side) / vec2(COLUMNS, ROWS);
    layer = uint(gl_InstanceIndex);
    float depth = (float(layer) + 0.5) / float(LAYERS);
    gl_Position = vec4(2.0 * at - 1.0, FRONT_TO_BACK ? depth : 1.0 - depth, 1.0);
    offset = (2.0 * vec2(side) - 1.0) * sqrt(-CUTOFF_EXPONENT);
}
