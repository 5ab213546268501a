// The `raster` stage as a compute kernel (model.md, step 10): each invocation blends a square of pixels near to far and stops when they
// are full, which a blender, taking all that comes, cannot. A workgroup takes a square of RASTER_REGION pixels.
#include "layout.glsl"
#include "splat.glsl"
#include "sort_control.glsl"
#include "bins.glsl"

layout(local_size_x = RASTER_SIZE) in;
layout(std430, set = 0, binding = 1) readonly buffer Splats { uvec4 splats[]; };  // then the keys
layout(std430, set = 0, binding = 2) buffer ControlBuffer { Control control; };
layout(std430, set = 0, binding = 3) readonly buffer Bins { uint bins[]; };
#ifdef WEB
layout(std430, set = 0, binding = 5) readonly buffer Keys { uint keys[]; };
#include "settings.glsl"
#define CUTOFF settings.cutoff
#define FULL settings.full
#define COUNT settings.count
#define REGION (settings.first_region + gl_WorkGroupID.xy)
#else
// Opacity under which nothing is drawn.
layout(constant_id = 0) const float CUTOFF = 1.0 / 255.0;
// A pixel is full when what lies behind would show by less than this.
layout(constant_id = 1) const float FULL = 1.0 / 512.0;
layout(constant_id = 2) const uint COUNT = 0u;
#define REGION gl_WorkGroupID.xy
#endif

const uint SIDE = RASTER_SQUARE;
// The square of pixels that an invocation blends.
struct Square {
    // Premultiplied colour, and how much of what lies behind shows.
    vec4 pixels[SIDE * SIDE];
    // Whether some pixel is not full.
    bool open;
    uint shaded;
    // px
    vec2 middle;
};

#ifdef WEB
uint key_at(uint i) { return keys[i >> 1u] >> 16u * (i & 1u) & 0xffffu; }
#else
uint key_at(uint i) {
    uint word = frame.key_start + (frame.half_keys != 0u ? i >> 1u : i);
    uint keys = splats[word >> 2u][word & 3u];
    return frame.half_keys != 0u ? keys >> (16u * (i & 1u)) & 0xffffu : keys;
}
#endif

uint step_back(uint chain) {
    return (chain & BINS_HELD) > 1u ? chain - 1u : bins[BINS_NODES + chain - 1u];
}

#ifdef TOGETHER
#include "raster_together.glsl"
#else
#include "raster_alone.glsl"
#endif

void store(uvec2 at, uvec2 size, vec4 pixel) {
    if (all(lessThan(at, size))) {
        imageStore(picture, ivec2(at), vec4(pixel.rgb, 1.0 - pixel.a));
    }
}

void main() {
    uint lane = lane_of_group();
    // Neighbours in a subgroup of any size are neighbours in the picture: bits of the lane are, from the lowest, x y x y x y.
    uvec2 place = uvec2((lane & 1u) | (lane >> 1u & 2u) | (lane >> 2u & 4u), (lane >> 1u & 1u) | (lane >> 2u & 2u) | (lane >> 3u & 4u));
    uvec2 first = REGION * RASTER_REGION + SIDE * place;
    Square square;
    square.open = true;
    square.shaded = 0u;
    square.middle = vec2(first) + 0.5 * float(SIDE);
    EACH_PIXEL(square.pixels[k] = vec4(0.0, 0.0, 0.0, 1.0))
    blend_tiles(square, uvec2(square.middle / frame.tile));
    uvec2 size = uvec2(frame.size);
    EACH_PIXEL(store(first + uvec2(k % SIDE, k / SIDE), size, square.pixels[k]))
    if (COUNT != 0u && square.shaded > 0u) {
        atomicAdd(control.fragments, square.shaded);
    }
}
