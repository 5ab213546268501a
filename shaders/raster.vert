// The quad of a splat (model.md, step 10): its corners lie where the splat's opacity falls to 1/255. RASTER_QUADS quads an instance.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "layout.glsl"
#include "splat.glsl"
#include "sort_control.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Order { uint order[]; };
layout(std430, set = 0, binding = 2) readonly buffer Splats { uvec4 splats[]; };  // then the keys
layout(std430, set = 0, binding = 3) readonly buffer ControlBuffer { Control control; };

// Where in the quad, in standard deviations.
layout(location = 0) out vec2 offset;
layout(location = 1) flat out vec4 color;

void main() {
    uint quad = uint(gl_InstanceIndex) * RASTER_QUADS + uint(gl_VertexIndex) / 4u;
    offset = vec2(0.0);
    color = vec4(0.0);
    // All corners of a quad past the last splat fall on one point.
    gl_Position = vec4(-2.0, -2.0, 0.0, 1.0);
    if (quad >= control.survivors) {
        return;
    }
    uint i = order[quad];
    Splat splat = unpack_splat(splats[i]);
    uint key_at = frame.key_start + (frame.half_keys > 0u ? i / 2u : i);
    uint key = splats[key_at / 4u][key_at & 3u];
    key = frame.half_keys > 0u ? key >> 16u * (i & 1u) & 0xffffu : key;
    float depth = 1.0 - float(key) / float(frame.key_max);
    float reach = reach_of(splat.opacity);
    offset = reach * vec2((gl_VertexIndex & 1) == 0 ? -1.0 : 1.0, (gl_VertexIndex & 2) == 0 ? -1.0 : 1.0);
    vec2 across = vec2(-splat.axis.y, splat.axis.x) * inversesqrt(dot(splat.axis, splat.axis)) * splat.shorter;
    vec2 at = splat.center + offset.x * splat.axis + offset.y * across;
    gl_Position = vec4(2.0 * at / frame.size - 1.0, depth, 1.0);
    color = vec4(splat.color, float(splat.opacity) / 255.0);
}
