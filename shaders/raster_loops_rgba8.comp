// `raster` as a compute kernel that is loops, into a picture of format rgba8.
#version 450
#extension GL_GOOGLE_include_directive : require
#define LOOPS
layout(set = 0, binding = 4, rgba8) writeonly uniform image2D picture;
#include "raster.glsl"
