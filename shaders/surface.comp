// The depth surface's pyramid: the drawn surface goes in, the furthest depth of each texel of SURFACE_LEVELS levels comes out.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "layout.glsl"

layout(local_size_x = SURFACE_WIDTH, local_size_y = SURFACE_HEIGHT) in;
// See pose.glsl.
layout(std430, set = 0, binding = 1) writeonly buffer PoseBuffer { uint pyramid[]; };
#ifdef WEB
#extension GL_EXT_samplerless_texture_functions : require
layout(set = 0, binding = 2) uniform texture2D surface;
#else
layout(set = 0, binding = 2) uniform sampler2D surface;
#endif

// In 65535ths, the depth image's own steps.
shared uint furthest[SURFACE_WIDTH * SURFACE_HEIGHT];

void main() {
    uvec2 local = gl_LocalInvocationID.xy;
    uvec2 texel = gl_GlobalInvocationID.xy;
    const uint drawn = SURFACE_DRAWN / SURFACE_FINEST;
    float depth = 0.0;
    for (uint k = 0u; k < drawn * drawn; ++k) {
        depth = max(depth, texelFetch(surface, ivec2(drawn * texel + uvec2(k % drawn, k / drawn)), 0).x);
    }
    uint here = local.y * SURFACE_WIDTH + local.x;
    furthest[here] = uint(ceil(65535.0 * depth - 0.01));
    uint start = 0u;
    for (uint level = 0u; level < SURFACE_LEVELS; ++level) {
        uint step = 1u << level;
        uint side = SURFACE_FINEST >> level;
        barrier();
        // The texel's furthest, and that of its neighbour, which shares the word.
        if (level > 0u && ((local.x | local.y) & (step - 1u)) == 0u) {
            uint near = step / 2u;
            furthest[here] = max(max(furthest[here], furthest[here + near]),
                                 max(furthest[here + near * SURFACE_WIDTH], furthest[here + near * SURFACE_WIDTH + near]));
        }
        barrier();
        if ((local.x & (2u * step - 1u)) == 0u && (local.y & (step - 1u)) == 0u) {
            uint at = start + (texel.y >> level) * side + (texel.x >> level);
            pyramid[frame.surface_start + at / 2u] = furthest[here] | furthest[here + step] << 16u;
        }
        start += side * side;
    }
}
