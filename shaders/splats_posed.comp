// `splats` where only the camera has moved: from what it kept of the pose to splats and keys.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "layout.glsl"
#include "splat.glsl"
#include "depth.glsl"
#include "posed.glsl"

layout(local_size_x = SPLATS_SIZE) in;
layout(std430, set = 0, binding = 1) readonly buffer PoseBuffer { uvec2 posed[]; };
layout(std430, set = 0, binding = 2) buffer Splats { uint words[]; };
#include "project.glsl"

// The splat at `slot` of the avatar's own; gives its key.
uint splat_of(uint slot) {
    uint at = frame.posed_start + 2u * slot;
    uvec2 place = uvec2(words[at], words[at + 1u]);
    uint opacity = place.y >> 24u;
    vec4 x = vec4(posed_position(place), 1.0);
    vec3 p = vec3(dot(frame.turn[0], x), dot(frame.turn[1], x), dot(frame.turn[2], x));
    vec2 center;
    float key;
    if (!lands(p, posed_longest(place), center, key)) {
        return SORT_DROPPED;
    }
    if (float(opacity) <= frame.cutoff) {
        left_out(FAINT);
        return SORT_DROPPED;
    }
    at = frame.posed_start + 2u * frame.gaussians + 3u * slot;
    uvec3 shape = uvec3(words[at], words[at + 1u], words[at + 2u]);
    mat3 turned = mat3(frame.turn[0].xyz, frame.turn[1].xyz, frame.turn[2].xyz);
    return draw(slot, p, center, key, turned, posed_axes(place, shape), posed_color(shape), opacity);
}

void main() {
    uint slot = gl_GlobalInvocationID.x;
    write_key(slot, slot < frame.drawn ? splat_of(slot) : SORT_DROPPED);
}
