// The `raster` stage as a compute kernel (model.md, step 10): each invocation blends a square of pixels near to far and stops when they
// are full, which a blender, taking all that comes, cannot. A workgroup takes a square of RASTER_REGION pixels.
#ifdef TOGETHER
#extension GL_EXT_control_flow_attributes : require
#define UNROLL [[unroll]]
#else
#define UNROLL
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

#ifndef TOGETHER
#include "raster_alone.glsl"
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

uint step_back(uint chain) {
    return (chain & BINS_HELD) > 1u ? chain - 1u : bins[BINS_NODES + chain - 1u];
}

#ifndef TOGETHER
#define FIRST(level) \
    if (chains.level != 0u) { \
        first.level = bins[BINS_NODES + chains.level]; \
        keys.level = key_at(first.level); \
    }
#define NEARER(level) \
    if (chains.level != 0u && (chain == 0u || keys.level > key || (keys.level == key && first.level > splat))) { \
        chain = chains.level; \
        splat = first.level; \
        key = keys.level; \
    }
#define STEP(level) \
    if (take.level) { \
        chains.level = rest; \
        first.level = next; \
        keys.level = after; \
    }

// One loop, since a loop takes as many turns as the lane that needs most, and what no lane needs is played all the same. `at`: column and
// row of the finest tile.
void blend_tiles(uvec2 at) {
    uvec4 tiles = uvec4(bins_tile(0u, at), bins_tile(1u, at >> 2u), bins_tile(2u, at >> 4u), bins_tile(BINS_WHOLE, uvec2(0u)));
    uint blocks = bins[BINS_MET + tiles.x] | bins[BINS_MET + tiles.y] | bins[BINS_MET + tiles.z] | bins[BINS_MET + tiles.w];
    // Where the block's chains are at each level, the splats that come first there, and their keys.
    uvec4 chains = uvec4(0u);
    uvec4 first = uvec4(0u);
    uvec4 keys = uvec4(0u);
    bool going = blocks != 0u;
    do {
        if (going) {
            if (chains == uvec4(0u)) {
                uint block = uint(findMSB(blocks));
                blocks ^= 1u << block;
                chains.x = bins[BINS_HEADS + tiles.x * BINS_BLOCKS + block];
                chains.y = bins[BINS_HEADS + tiles.y * BINS_BLOCKS + block];
                chains.z = bins[BINS_HEADS + tiles.z * BINS_BLOCKS + block];
                chains.w = bins[BINS_HEADS + tiles.w * BINS_BLOCKS + block];
                FIRST(x) FIRST(y) FIRST(z) FIRST(w)
            }
            uint splat = 0u;
            uint key = 0u;
            uint chain = 0u;
            NEARER(x) NEARER(y) NEARER(z) NEARER(w)
            bvec4 take = equal(chains, uvec4(chain));
            uint rest = step_back(chain);
            uint next = rest == 0u ? 0u : bins[BINS_NODES + rest];
            uint after = rest == 0u ? 0u : key_at(next);
            STEP(x) STEP(y) STEP(z) STEP(w)
            put(splats[splat]);
        }
        going = open && (blocks != 0u || chains != uvec4(0u));
    } while (going);
}
#else
// Blends a block's chains of all levels as one: larger keys are nearer, of equal ones larger numbers.
void blend_merged(uvec4 chains) {
    uvec4 first = uvec4(0u);
    uvec4 keys = uvec4(0u);
    UNROLL for (uint level = 0u; level < BINS_LEVELS; ++level) {
        if (chains[level] != 0u) {
            first[level] = bins[BINS_NODES + chains[level]];
            keys[level] = key_at(first[level]);
        }
    }
    while (open && chains != uvec4(0u)) {
        uint take = BINS_LEVELS;
        uint splat = 0u;
        uint key = 0u;
        UNROLL for (uint level = 0u; level < BINS_LEVELS; ++level) {
            bool ahead = take == BINS_LEVELS || keys[level] > key || (keys[level] == key && first[level] > splat);
            if (chains[level] != 0u && ahead) {
                take = level;
                splat = first[level];
                key = keys[level];
            }
        }
        blend(ready(splats[splat]));
        UNROLL for (uint level = 0u; level < BINS_LEVELS; ++level) {
            if (level == take) {
                chains[level] = step_back(chains[level]);
                if (chains[level] != 0u) {
                    first[level] = bins[BINS_NODES + chains[level]];
                    keys[level] = key_at(first[level]);
                }
            }
        }
    }
}

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

// The tiles of all levels at a place, columns and rows of the finest.
void blend_tiles(uvec2 at) {
    uvec4 tiles;
    uint blocks = 0u;
    UNROLL for (uint level = 0u; level < BINS_LEVELS; ++level) {
        tiles[level] = bins_tile(level, level < BINS_WHOLE ? at >> 2u * level : uvec2(0u));
        blocks |= bins[BINS_MET + tiles[level]];
    }
    while (blocks != 0u && subgroupAny(open)) {
        uint block = uint(findMSB(blocks));
        blocks ^= 1u << block;
        uvec4 chains;
        uint all = 0u;
        bool one = true;
        UNROLL for (uint level = 0u; level < BINS_LEVELS; ++level) {
            chains[level] = bins[BINS_HEADS + tiles[level] * BINS_BLOCKS + block];
            one = one && (all == 0u || chains[level] == 0u);
            all |= chains[level];
        }
        if (one) {
            blend_chain(all);
        } else {
            blend_merged(chains);
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
#ifndef TOGETHER
    read_uniforms();
#endif
    uvec2 first = gl_WorkGroupID.xy * RASTER_REGION + SIDE * place;
    middle = vec2(first) + 0.5 * float(SIDE);
    blend_tiles(uvec2(middle / frame.tile));
    UNROLL for (uint k = 0u; k < SIDE * SIDE; ++k) {
        uvec2 pixel = first + uvec2(k % SIDE, k / SIDE);
        if (all(lessThan(pixel, uvec2(frame.size)))) {
            imageStore(picture, ivec2(pixel), vec4(pixels[k].rgb, 1.0 - pixels[k].a));
        }
    }
    if (COUNT != 0u && shaded > 0u) {
        atomicAdd(control.fragments, shaded);
    }
}
