// What the shaders of the draw share. Opacities are powers of two here: a Gaussian is one too, so that they add up, and a standard
// deviation of √(2 ln 2) is where it falls by 1.

// Only what says so may have 16 bits.
precision highp float;
precision highp int;

// Exponent of the opacity under which nothing is drawn.
#ifdef WEB
#include "settings.glsl"
#define LEAST settings.least
#else
layout(constant_id = 0) const float LEAST = -7.994353;
#endif
