// The cooperative tile rasterizer, whose subgroups lie in one tile, into an image of format rgba8.
#version 450
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_vote : require
layout(set = 0, binding = 4, rgba8) writeonly uniform image2D image;
#include "raster/tiles.glsl"
#include "raster/cooperative.glsl"
#include "raster/tiles_main.glsl"
