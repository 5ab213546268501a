// The depth pyramid, from the image of the occluder's depth: the furthest depth in each texel of
// PYRAMID_LEVELS levels.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"
#include "common/frame.glsl"

layout(local_size_x = PYRAMID_WORKGROUP_WIDTH, local_size_y = PYRAMID_WORKGROUP_HEIGHT) in;
// See common/pose.glsl.
layout(std430, set = 0, binding = 1) writeonly buffer PoseBuffer { uint pyramid[]; };
layout(set = 0, binding = 2) uniform IMAGE_2D occluder;

// In 65535ths, the steps of the depth image.
shared uint furthest[PYRAMID_WORKGROUP_WIDTH * PYRAMID_WORKGROUP_HEIGHT];

void main() {
    uvec2 local = gl_LocalInvocationID.xy;
    uvec2 texel = gl_GlobalInvocationID.xy;
    // Texels of the image along each side of one of the finest level.
    const uint span = OCCLUDER_SIDE / PYRAMID_SIDE;
    float depth = 0.0;
    for (uint k = 0u; k < span * span; ++k) {
        ivec2 at = ivec2(span * texel + uvec2(k % span, k / span));
        depth = max(depth, texelFetch(occluder, at, 0).x);
    }
    uint here = local.y * PYRAMID_WORKGROUP_WIDTH + local.x;
    furthest[here] = uint(ceil(65535.0 * depth - 0.01));
    uint start = 0u;
    for (uint level = 0u; level < PYRAMID_LEVELS; ++level) {
        uint step = 1u << level;
        uint side = PYRAMID_SIDE >> level;
        barrier();
        // The furthest of the four texels of the level before.
        if (level > 0u && ((local.x | local.y) & (step - 1u)) == 0u) {
            uint near = step / 2u;
            uint row = near * PYRAMID_WORKGROUP_WIDTH;
            furthest[here] = max(max(furthest[here], furthest[here + near]),
                                 max(furthest[here + row], furthest[here + row + near]));
        }
        barrier();
        // Two neighbours share a word.
        if ((local.x & (2u * step - 1u)) == 0u && (local.y & (step - 1u)) == 0u) {
            uint at = start + (texel.y >> level) * side + (texel.x >> level);
            pyramid[frame.pyramid_start + at / 2u] = furthest[here] | furthest[here + step] << 16u;
        }
        start += side * side;
    }
}
