// `project` if only the camera has moved: from the pose cache to splats and keys.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"
#include "common/frame.glsl"
#include "common/splat.glsl"
#include "common/depth_key.glsl"
#include "project/facing.glsl"
#include "project/pose_cache.glsl"

layout(local_size_x = PROJECT_WORKGROUP) in;
layout(std430, set = 0, binding = 1) buffer Splats { uint words[]; };
#include "project/projection.glsl"

// Writes the splat at `index` of the avatar's own; gives its key.
uint project_gaussian(uint index) {
    uint at = frame.cache_start + 3u * index;
    uvec3 position = uvec3(words[at], words[at + 1u], words[at + 2u]);
    uint opacity = position.y >> 24u;
    vec4 x = vec4(cached_position(position), 1.0);
    vec3 p = vec3(dot(frame.camera_from_cache[0], x), dot(frame.camera_from_cache[1], x),
                  dot(frame.camera_from_cache[2], x));
    mat3 rows = mat3(frame.camera_from_cache[0].xyz, frame.camera_from_cache[1].xyz,
                     frame.camera_from_cache[2].xyz);
    vec2 center;
    float key;
    if (!project_center(p, center, key)) {
        return SORT_CULLED;
    }
    float fade = 1.0;
    if (frame.facing_start > index) {
        uint facing = words[cached_facing_at(index)];
        fade = facing_fade(cached_axis(facing) * rows, facing >> 24u, p);
        if (fade <= 0.0) {
            count_culled(AWAY);
            return SORT_CULLED;
        }
    }
    // The size is that along an axis: no deviation is larger than √3 times that.
    if (misses_area(p, center, rows, sqrt(3.0) * cached_size(position))) {
        return SORT_CULLED;
    }
    if (float(opacity) <= frame.cutoff) {
        count_culled(FAINT);
        return SORT_CULLED;
    }
    at = frame.cache_start + 3u * (frame.drawn + index);
    uvec3 shape = uvec3(words[at], words[at + 1u], words[at + 2u]);
    return write_splat(index, p, center, key, rows, cached_axes(position, shape),
                       cached_color(shape), opacity, fade);
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index < frame.drawn) {
        write_key(index, project_gaussian(index));
    }
}
