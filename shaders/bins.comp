// The `bins` stage: the order and the splats go in, which of them meet which tile comes out (bins.glsl). An invocation takes a block.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "layout.glsl"
#include "splat.glsl"
#include "sort_control.glsl"
#include "bins.glsl"

layout(local_size_x = BINS_SIZE) in;
layout(std430, set = 0, binding = 1) readonly buffer Order { uint order[]; };
layout(std430, set = 0, binding = 2) readonly buffer Splats { uvec4 splats[]; };
layout(std430, set = 0, binding = 3) buffer ControlBuffer { Control control; };
layout(std430, set = 0, binding = 4) buffer Bins { uint bins[]; };
// Nodes for the tiles. After them come those for the chains of the whole picture, as many as every block can need.
#ifdef WEB
#include "settings.glsl"
#define NODES settings.nodes
#else
layout(constant_id = 0) const uint NODES = 1u;
#endif

bool full(uint chain) {
    return chain == 0u || (chain & BINS_HELD) == BINS_HELD;
}

// Puts a splat in front of a chain. `node` is taken where the chain's first is full.
void put(uint splat, uint head, uint chain, uint node) {
    if (full(chain)) {
        bins[BINS_NODES + BINS_NODE * node] = chain;
        chain = BINS_NODE * node;
    }
    ++chain;
    bins[BINS_NODES + chain] = splat;
    bins[head] = chain;
}

uint head_of(uint level, uvec2 at, uint block) {
    return BINS_HEADS + bins_tile(level, at) * BINS_BLOCKS + block;
}

void main() {
    uint block = gl_GlobalInvocationID.x;
    if (block == 0u) {
        control.fragments = 0u;
    }
    uint length = (control.survivors + BINS_BLOCKS - 1u) / BINS_BLOCKS;
    uint end = min((block + 1u) * length, control.survivors);
    // The nodes of the block's own chain for the whole picture.
    uint whole = NODES + 1u + block * ((length + BINS_HELD - 1u) / BINS_HELD);
    // From far to near: what is put in front of a chain last is the nearest.
    for (uint number = block * length; number < end; ++number) {
        uint i = order[number];
        Splat splat = unpack_splat(splats[i]);
        vec2 reach = half_box(splat, reach_of(splat.opacity));
        uvec2 low = uvec2(0u);
        uvec2 high = uvec2(0u);
        uint node = 0u;
        uint level = 0u;
        for (; level < BINS_WHOLE; ++level) {
            float side = frame.tile * float(1u << 2u * level);
            float last = float((FINEST >> 2u * level) - 1u);
            low = uvec2(clamp((splat.center - reach) / side, 0.0, last));
            high = uvec2(clamp((splat.center + reach) / side, 0.0, last));
            if ((high.x - low.x + 1u) * (high.y - low.y + 1u) > BINS_NARROW) {
                continue;
            }
            uint needed = 0u;
            for (uint y = low.y; y <= high.y; ++y) {
                for (uint x = low.x; x <= high.x; ++x) {
                    needed += full(bins[head_of(level, uvec2(x, y), block)]) ? 1u : 0u;
                }
            }
            node = needed > 0u ? atomicAdd(bins[0], needed) + 1u : 1u;
            if (node + needed <= NODES + 1u) {
                break;
            }
        }
        if (level == BINS_WHOLE) {
            low = uvec2(0u);
            high = uvec2(0u);
            node = whole;
            whole += full(bins[head_of(BINS_WHOLE, low, block)]) ? 1u : 0u;
        }
        for (uint y = low.y; y <= high.y; ++y) {
            for (uint x = low.x; x <= high.x; ++x) {
                uint head = head_of(level, uvec2(x, y), block);
                uint chain = bins[head];
                if (chain == 0u) {
                    atomicOr(bins[BINS_MET + bins_tile(level, uvec2(x, y))], 1u << block);
                }
                put(i, head, chain, node);
                node += full(chain) ? 1u : 0u;
            }
        }
    }
}
