// The tile rasterizer, a compute kernel (model.md, step 10): each invocation blends a square of
// pixels near to far and stops when they are saturated. The blender, which the quads use, cannot
// stop. A workgroup draws a region of RASTER_REGION by RASTER_REGION pixels.
//
// The including shader declares `image` before this file, then includes cooperative.glsl, which
// walks the tiles' lists, and then tiles_main.glsl.
#include "common/platform.glsl"
#include "common/frame.glsl"
#include "common/splat.glsl"
#include "common/control.glsl"
#include "common/tiles.glsl"

layout(local_size_x = RASTER_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Splats { uvec4 splats[]; };  // then the keys
layout(std430, set = 0, binding = 2) buffer ControlBuffer { Control control; };
layout(std430, set = 0, binding = 3) readonly buffer Bins { uint bins[]; };
// Opacity under which nothing is drawn.
PARAMETER(0, float, CUTOFF, 1.0 / 255.0)
// A pixel is saturated if what lies behind would show by less than this.
PARAMETER(1, float, SATURATION, 1.0 / 512.0)
// Whether fragments are counted.
PARAMETER(2, bool, COUNTED, false)

const uint SIDE = RASTER_SQUARE;
// √(½ log₂ e): in standard deviations times this, a Gaussian is 2^−|deviation|².
const float DEVIATION_UNIT = 0.84932180;
// The least low-pass, 0.1 px², lets no Gaussian fall faster than from its cutoff to 2^−119 over a row
// of four pixels, by 2^51 from one to the next. A row that starts with less weight than 2^−120, which
// f32 holds still, does not count.
const float WEIGHT_MIN = 7.5e-37;
const float FACTOR_EXPONENT_MAX = 60.0;

// The square of pixels that an invocation blends.
struct Square {
    // Premultiplied colour, and how much of what lies behind shows. Rows of four.
    vec4 pixels[SIDE * SIDE];
    // Whether some pixel is not saturated.
    bool open;
    // Pixels evaluated.
    uint fragments;
    // px
    vec2 middle;
};

#include "common/key_at.glsl"

// A list without its first splat.
uint rest_of(uint list) {
    return (list & SPLATS_PER_BLOCK) > 1u ? list - 1u : bins[BLOCKS_START + list - 1u];
}
