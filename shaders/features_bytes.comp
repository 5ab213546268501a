// Networks whose weights are bytes, with a step a neuron: half of what must be read.
#version 450
#extension GL_GOOGLE_include_directive : require
#define BYTE_WEIGHTS
#include "features.glsl"
