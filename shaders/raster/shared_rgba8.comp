// The shared-memory tile rasterizer, into an image of format rgba8.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
layout(set = 0, binding = 5, rgba8) writeonly uniform image2D image;
#include "raster/shared.glsl"
