// A fragment of a layer: as short as a fragment can be that differs from layer to layer, or the
// fragment of a Gaussian, as raster/quads.frag has it.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "rates/fill.glsl"

EARLY_FRAGMENT_TESTS
layout(location = 0) in mediump vec2 offset;
layout(location = 1) flat in uint layer;
layout(location = 0) out vec4 result;

void main() {
    float opacity = OPACITY;
    if (CUTOFF_EXPONENT < 0.0) {
        float exponent = -dot(offset, offset);
        if (exponent < CUTOFF_EXPONENT) {
            discard;
        }
        opacity *= exp2(exponent);
    }
    vec3 color = vec3(uvec3(layer, layer >> 2u, layer >> 4u) & 3u) * 0.25;
    // "Over" multiplies by the opacity in the blender, as the quads do; "under" can't.
    result = vec4(FRONT_TO_BACK ? color * opacity : color, opacity);
}
