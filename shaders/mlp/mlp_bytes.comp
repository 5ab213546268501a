// Networks whose weights are bytes with one step a neuron, half as much to read as f16.
#version 450
#extension GL_GOOGLE_include_directive : require
#define BYTE_WEIGHTS
#include "mlp/mlp.glsl"
