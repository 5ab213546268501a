// The per-thread tile rasterizer, into an image of format rgba8.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(set = 0, binding = 4, rgba8) writeonly uniform image2D image;
#include "raster/tiles.glsl"
#include "raster/per_thread.glsl"
#include "raster/tiles_main.glsl"
