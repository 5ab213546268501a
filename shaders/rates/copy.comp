// Copies one buffer to another, 16 bytes an invocation: what a device's memory can do for a kernel.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"

layout(local_size_x = RATES_WORKGROUP) in;

// Numbers of four words.
PARAMETER(0, uint, COUNT, 0u)

layout(std430, set = 0, binding = 1) readonly buffer From { uvec4 from[]; };
layout(std430, set = 0, binding = 2) writeonly buffer To { uvec4 to[]; };

void main() {
    uint row = gl_NumWorkGroups.x * RATES_WORKGROUP;
    uint at = gl_WorkGroupID.y * row + gl_GlobalInvocationID.x;
    if (at < COUNT) {
        to[at] = from[at];
    }
}
