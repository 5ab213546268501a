// The depth surface's pyramid: the drawn surface goes in, the furthest depth of each texel of SURFACE_LEVELS levels comes out.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "layout.glsl"

layout(local_size_x = SURFACE_SIZE, local_size_y = SURFACE_SIZE) in;
layout(std430, set = 0, binding = 1) writeonly buffer PoseBuffer { float pyramid[]; };
layout(set = 0, binding = 2) uniform sampler2D surface;

shared float furthest[SURFACE_SIZE * SURFACE_SIZE];

void main() {
    uvec2 local = gl_LocalInvocationID.xy;
    uvec2 texel = gl_GlobalInvocationID.xy;
    const uint drawn = SURFACE_DRAWN / SURFACE_FINEST;
    float depth = 0.0;
    for (uint k = 0u; k < drawn * drawn; ++k) {
        depth = max(depth, texelFetch(surface, ivec2(drawn * texel + uvec2(k % drawn, k / drawn)), 0).x);
    }
    uint start = frame.surface_start;
    pyramid[start + texel.y * SURFACE_FINEST + texel.x] = depth;
    uint here = local.y * SURFACE_SIZE + local.x;
    furthest[here] = depth;
    for (uint level = 1u; level < SURFACE_LEVELS; ++level) {
        barrier();
        start += (SURFACE_FINEST >> (level - 1u)) * (SURFACE_FINEST >> (level - 1u));
        uint step = 1u << (level - 1u);
        if (((local.x | local.y) & (2u * step - 1u)) == 0u) {
            depth = max(max(furthest[here], furthest[here + step]),
                        max(furthest[here + step * SURFACE_SIZE], furthest[here + step * SURFACE_SIZE + step]));
            furthest[here] = depth;
            pyramid[start + (texel.y >> level) * (SURFACE_FINEST >> level) + (texel.x >> level)] = depth;
        }
    }
}
