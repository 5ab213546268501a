// Networks whose weights are f16.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "mlp/mlp.glsl"
