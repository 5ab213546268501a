// The colour of each Gaussian as the camera sees it, from spherical harmonics: an invocation a
// drawn Gaussian. It replaces the neutral colour, to which `project` adds the corrective.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"
#include "common/half.glsl"
#include "common/frame.glsl"
#include "common/gaussian.glsl"

layout(local_size_x = SH_WORKGROUP) in;
layout(std430, set = 0, binding = 1) buffer Gaussians { uvec2 gaussians[]; };
// Planes of half quads, one entry a Gaussian, three planes for each group of four functions: RGB of
// each function in turn, the neutral colour as that of the first. Two buffers, so that the largest
// avatar stays within the buffer range that every device has.
layout(std430, set = 0, binding = 2) readonly buffer Low { uvec2 low[]; };
layout(std430, set = 0, binding = 3) readonly buffer High { uvec2 high[]; };
layout(std430, set = 0, binding = 4) readonly buffer PoseBuffer { uvec2 pose[]; };
#include "common/pose.glsl"
PARAMETER(0, uint, DEGREE, 3u)

vec3 weigh(vec4 a, vec4 b, vec4 c, vec4 function) {
    return function.x * a.xyz + function.y * vec3(a.w, b.xy) + function.z * vec3(b.zw, c.x) +
           function.w * c.yzw;
}

vec3 from_low(uint group, uint i, vec4 function) {
    uint at = 3u * group * frame.gaussians + i;
    return weigh(widen(low[at]), widen(low[at + frame.gaussians]),
                 widen(low[at + 2u * frame.gaussians]), function);
}

vec3 from_high(uint group, uint i, vec4 function) {
    uint at = 3u * group * frame.gaussians + i;
    return weigh(widen(high[at]), widen(high[at + frame.gaussians]),
                 widen(high[at + 2u * frame.gaussians]), function);
}

// Unit direction from the camera to the Gaussian, in canonical space. The camera is the origin of its
// own space.
vec3 direction(uvec2 position, uvec2 skin, uvec2 near) {
    uvec4 joint = gaussian_joints(skin);
    vec4 weight = gaussian_weights(skin);
    vec4 r0 = vec4(0.0), r1 = vec4(0.0), r2 = vec4(0.0);
    for (uint k = 0u; k < 4u; ++k) {
        uint at = 3u * joint[k];
        r0 += weight[k] * frame.joint[at];
        r1 += weight[k] * frame.joint[at + 1u];
        r2 += weight[k] * frame.joint[at + 2u];
    }
    vec3 node_weight = gaussian_node_weights(near);
    uvec3 node = gaussian_nodes(near);
    vec4 x = vec4(gaussian_position(position) + node_weight.x * displacement_of(node.x) +
                      node_weight.y * displacement_of(node.y) +
                      node_weight.z * displacement_of(node.z), 1.0);
    vec3 d = dot(r0, x) * r0.xyz + dot(r1, x) * r1.xyz + dot(r2, x) * r2.xyz;
    float size = length(d);
    return size > 0.0 ? d / size : vec3(0.0);
}

void main() {
    if (gl_GlobalInvocationID.x >= frame.drawn) {
        return;
    }
    uint i = gl_GlobalInvocationID.x << frame.detail_level;
    vec3 d = direction(gaussians[2u * i], gaussians[2u * i + 1u],
                       gaussians[2u * frame.gaussians + i]);
    float x = d.x, y = d.y, z = d.z;
    float xx = x * x, yy = y * y, zz = z * z;
    vec3 color = from_low(0u, i, vec4(1.0, 0.48860251190 * vec3(-y, z, -x)));
    if (DEGREE >= 2u) {
        color += from_low(1u, i,
                          vec4(1.09254843059 * x * y, -1.09254843059 * y * z,
                               0.31539156525 * (2.0 * zz - xx - yy), -1.09254843059 * x * z));
        vec4 function = vec4(0.54627421530 * (xx - yy), 0.0, 0.0, 0.0);
        if (DEGREE >= 3u) {
            function.yzw = vec3(-0.59004358993 * y * (3.0 * xx - yy), 2.89061144264 * x * y * z,
                                -0.45704579946 * y * (4.0 * zz - xx - yy));
            color += from_high(1u, i,
                               vec4(0.37317633259 * z * (2.0 * zz - 3.0 * (xx + yy)),
                                    -0.45704579946 * x * (4.0 * zz - xx - yy),
                                    1.44530572132 * z * (xx - yy),
                                    -0.59004358993 * x * (xx - 3.0 * yy)));
        }
        color += from_high(0u, i, function);
    }
    color = clamp(color, 0.0, F16_MAX);
    gaussians[frame.sh_color_start + i] =
        uvec2(packHalf2x16(color.rg), packHalf2x16(vec2(color.b, 0.0)));
}
