// The `raster` stage as a compute kernel (model.md, step 10): each invocation blends a square of pixels near to far and stops when they
// are full, which a blender, taking all that comes, cannot. A workgroup takes a square of RASTER_REGION pixels.
#if defined(LOOPS) || defined(WEB)
#define NARROW
#define UNROLL
#else
#extension GL_EXT_control_flow_attributes : require
#define UNROLL [[unroll]]
#endif
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
#else
// Opacity under which nothing is drawn.
layout(constant_id = 0) const float CUTOFF = 1.0 / 255.0;
// A pixel is full when what lies behind would show by less than this.
layout(constant_id = 1) const float FULL = 1.0 / 512.0;
layout(constant_id = 2) const uint COUNT = 0u;
#endif

const uint SIDE = RASTER_SQUARE;
// Premultiplied colour, and how much of what lies behind shows.
vec4 pixels[SIDE * SIDE];
uint shaded = 0u;
// Whether some pixel is not full.
bool open = true;
// Centre of the square, px.
vec2 middle;

#ifdef NARROW
#include "raster_narrow.glsl"
#else
// A splat, ready to be put on pixels. Standard deviations are times √(½ log₂ e): the Gaussian is 2^−|deviation|².
struct Ready {
    vec2 center;
    vec2 reach;
    // From pixels to standard deviations.
    vec2 along;
    vec2 across;
    vec4 color;
    // By what the change from a pixel to the next changes.
    float bend;
};

Ready ready(uvec4 words) {
    Splat splat = unpack_splat(words);
    const float unit = 0.84932180;
    float inverse = 1.0 / dot(splat.axis, splat.axis);
    Ready r;
    r.center = splat.center;
    r.reach = half_box(splat, reach_of(splat.opacity));
    r.along = unit * inverse * splat.axis;
    r.across = unit * sqrt(inverse) / splat.shorter * vec2(-splat.axis.y, splat.axis.x);
    r.color = vec4(splat.color, float(splat.opacity) / 255.0);
    r.bend = exp2(-2.0 * (r.along.x * r.along.x + r.across.x * r.across.x));
    return r;
}

// Puts a splat behind what the pixels hold.
void blend(Ready splat) {
    const float half_side = 0.5 * float(SIDE - 1u);
    vec2 from = middle - splat.center;
    if (!(open && all(lessThan(abs(from), splat.reach + half_side)))) {
        return;
    }
    from -= half_side;
    vec2 deviation = vec2(dot(from, splat.along), dot(from, splat.across));
    vec2 right = vec2(splat.along.x, splat.across.x);
    float most = 0.0;
    UNROLL for (uint y = 0u; y < SIDE; ++y) {
        // From a pixel to the next the Gaussian changes by a factor, which itself changes by a constant one. The low-pass lets no
        // Gaussian fall faster than from its cutoff to 2^−56 over a row of four: what starts lower does not count.
        float weight = exp2(-dot(deviation, deviation));
        float alpha = weight >= 1e-17 ? splat.color.a * weight : 0.0;
        float factor = exp2(min(-dot(2.0 * deviation + right, right), 60.0));
        UNROLL for (uint x = 0u; x < SIDE; ++x) {
            uint k = y * SIDE + x;
            float covers = min(alpha, 0.99);
            float share = covers >= CUTOFF ? covers * pixels[k].a : 0.0;
            pixels[k] = vec4(pixels[k].rgb + share * splat.color.rgb, pixels[k].a - share);
            most = max(most, pixels[k].a);
            alpha *= factor;
            factor *= splat.bend;
        }
        deviation += vec2(splat.along.y, splat.across.y);
    }
    shaded += SIDE * SIDE;
    open = most >= FULL;
}
#endif

#ifdef WEB
uint key_at(uint i) { return keys[i >> 1u] >> 16u * (i & 1u) & 0xffffu; }
#else
uint key_at(uint i) {
    uint word = frame.key_start + (frame.half_keys != 0u ? i >> 1u : i);
    uint keys = splats[word >> 2u][word & 3u];
    return frame.half_keys != 0u ? keys >> (16u * (i & 1u)) & 0xffffu : keys;
}
#endif

// Whether splat `a` is drawn after splat `b` in the order: larger keys are nearer.
bool nearer(uint a, uint b) {
    uint key = key_at(a);
    uint than = key_at(b);
    return key > than || (key == than && a > b);
}

uint step_back(uint chain) {
    return (chain & BINS_HELD) > 1u ? chain - 1u : bins[BINS_NODES + chain - 1u];
}

#ifdef NARROW
// One loop, since a loop takes as many turns as the lane that needs most, and what no lane needs is played all the same.
void blend_tile(uint tile) {
    uint wide = bins[1];
    uint blocks = bins[BINS_MET + tile] | wide;
    uint here = 0u, everywhere = 0u;
    bool going = blocks != 0u;
    do {
        if (going) {
            if ((here | everywhere) == 0u) {
                uint block = uint(findMSB(blocks));
                blocks ^= 1u << block;
                here = bins[BINS_HEADS + tile * BINS_BLOCKS + block];
                everywhere = (wide >> block & 1u) == 0u ? 0u : bins[BINS_WIDE + block];
            }
            uint near = here == 0u ? 0u : bins[BINS_NODES + here];
            uint other = everywhere == 0u ? 0u : bins[BINS_NODES + everywhere];
            bool wider = here == 0u || (everywhere != 0u && nearer(other, near));
            uint rest = step_back(wider ? everywhere : here);
            here = wider ? here : rest;
            everywhere = wider ? rest : everywhere;
            put(splats[wider ? other : near]);
        }
        going = open && (blocks | here | everywhere) != 0u;
    } while (going);
}
#else
// Blends two chains as one.
void blend_both(uint here, uint everywhere) {
    while (open && (here | everywhere) != 0u) {
        uint near = here == 0u ? 0u : bins[BINS_NODES + here];
        uint other = everywhere == 0u ? 0u : bins[BINS_NODES + everywhere];
        bool wide = here == 0u || (everywhere != 0u && nearer(other, near));
        if (wide) {
            everywhere = step_back(everywhere);
        } else {
            here = step_back(here);
        }
        blend(ready(splats[wide ? other : near]));
    }
}

#ifdef TOGETHER
// A subgroup lies in one tile: its invocations read a node together, a splat each, and hand round those that meet the subgroup's pixels.
// They stay together until all are done.
void blend_chain(uint chain) {
    uint lane = gl_SubgroupInvocationID;
    vec2 low = subgroupMin(middle);
    vec2 high = subgroupMax(middle);
    vec2 center = 0.5 * (low + high);
    vec2 box = 0.5 * (high - low) + 0.5 * float(SIDE - 1u);
    while (chain != 0u && subgroupAny(open)) {
        uint held = chain & BINS_HELD;
        uint word = lane < BINS_NODE ? bins[BINS_NODES + chain - held + lane] : 0u;
        bool mine = lane > 0u && lane <= held;
        Ready splat = ready(mine ? splats[word] : uvec4(0u));
        uint meets = subgroupBallot(mine && all(lessThan(abs(center - splat.center), splat.reach + box))).x;
        while (meets != 0u) {
            uint from = uint(findMSB(meets));
            meets ^= 1u << from;
            Ready next;
            next.center = subgroupShuffle(splat.center, from);
            next.reach = subgroupShuffle(splat.reach, from);
            next.along = subgroupShuffle(splat.along, from);
            next.across = subgroupShuffle(splat.across, from);
            next.color = subgroupShuffle(splat.color, from);
            next.bend = subgroupShuffle(splat.bend, from);
            blend(next);
        }
        chain = subgroupShuffle(word, 0u);
    }
}
#else
void blend_chain(uint chain) {
    blend_both(chain, 0u);
}
#endif

void blend_tile(uint tile) {
    uint wide = bins[1];
    uint blocks = bins[BINS_MET + tile] | wide;
#ifdef TOGETHER
    while (blocks != 0u && subgroupAny(open)) {
#else
    while (blocks != 0u && open) {
#endif
        uint block = uint(findMSB(blocks));
        blocks ^= 1u << block;
        uint here = bins[BINS_HEADS + tile * BINS_BLOCKS + block];
        if ((wide >> block & 1u) == 0u) {
            blend_chain(here);
        } else {
            blend_both(here, bins[BINS_WIDE + block]);
        }
    }
}
#endif

void main() {
    UNROLL for (uint k = 0u; k < SIDE * SIDE; ++k) {
        pixels[k] = vec4(0.0, 0.0, 0.0, 1.0);
    }
#ifdef TOGETHER
    uint lane = gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
#else
    uint lane = gl_LocalInvocationIndex;
#endif
    // Neighbours in a subgroup of any size are neighbours in the picture: bits of the lane are, from the lowest, x y x y x y.
    uvec2 place = uvec2((lane & 1u) | (lane >> 1u & 2u) | (lane >> 2u & 4u), (lane >> 1u & 1u) | (lane >> 2u & 2u) | (lane >> 3u & 4u));
#ifdef NARROW
    read_uniforms();
#endif
    uvec2 first = gl_WorkGroupID.xy * RASTER_REGION + SIDE * place;
    middle = vec2(first) + 0.5 * float(SIDE);
    uvec2 tile = first / uint(frame.tile);
    blend_tile(tile.y * BINS_SIDE + tile.x);
    UNROLL for (uint k = 0u; k < SIDE * SIDE; ++k) {
        uvec2 pixel = first + uvec2(k % SIDE, k / SIDE);
        if (all(lessThan(vec2(pixel), frame.size))) {
            imageStore(picture, ivec2(pixel), vec4(pixels[k].rgb, 1.0 - pixels[k].a));
        }
    }
    if (COUNT != 0u && shaded > 0u) {
        atomicAdd(control.fragments, shaded);
    }
}
