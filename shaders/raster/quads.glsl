// What the shaders of the quads share. Opacities are exponents of two here: a Gaussian is a power
// of two as well, so that they add up. A standard deviation of √(2 ln 2) is where it falls by 1.

// Only what is declared mediump may have 16 bits.
precision highp float;
precision highp int;
#include "common/platform.glsl"

// Exponent of the opacity under which nothing is drawn.
PARAMETER(0, float, CUTOFF_EXPONENT, -7.994353)
