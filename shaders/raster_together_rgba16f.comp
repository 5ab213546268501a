// `raster` as a compute kernel whose subgroups lie in one tile, into a picture of format rgba16f.
#version 450
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_vote : require
#define TOGETHER
layout(set = 0, binding = 4, rgba16f) writeonly uniform image2D picture;
#include "raster.glsl"
