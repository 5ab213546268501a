// What the shaders of the fill rates share.
precision highp float;
precision highp int;
#include "common/platform.glsl"

// Quads across and down the image.
PARAMETER(0, uint, COLUMNS, 1u)
PARAMETER(1, uint, ROWS, 1u)
// Most layers, which share the depths; and whether the first of them is the nearest.
PARAMETER(2, uint, LAYERS, 1u)
PARAMETER(3, bool, FRONT_TO_BACK, false)
// Exponent of the opacity under which a Gaussian is not drawn. 0: every layer is the same all over.
PARAMETER(4, float, CUTOFF_EXPONENT, 0.0)
// Opacity where it is largest.
PARAMETER(5, float, OPACITY, 1.0)
