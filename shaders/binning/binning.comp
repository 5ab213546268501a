// Tile binning: from the drawing order and the splats to the lists of each tile
// (common/tiles.glsl). An invocation takes a run of the order.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"
#include "common/frame.glsl"
#include "common/splat.glsl"
#include "common/control.glsl"
#include "common/tiles.glsl"

layout(local_size_x = BINNING_WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Order { uint order[]; };
layout(std430, set = 0, binding = 2) readonly buffer Splats { uvec4 splats[]; };
layout(std430, set = 0, binding = 3) buffer ControlBuffer { Control control; };
layout(std430, set = 0, binding = 4) buffer Bins { uint bins[]; };
// Blocks that the tiles share. After them come those for the lists of the whole image, as many as
// the runs can need.
PARAMETER(0, uint, BLOCKS, 1u)

// Whether a list's first block takes no more splats. `head`: the list's.
bool needs_block(uint head) {
    return head == 0u || (head & SPLATS_PER_BLOCK) == SPLATS_PER_BLOCK;
}

// Puts a splat in front of a list. `at`: the word of its head. `block`: number of the block that is
// used if the list's first is full.
void push(uint splat, uint at, uint head, uint block) {
    if (needs_block(head)) {
        bins[BLOCKS_START + BINNING_BLOCK * block] = head;
        head = BINNING_BLOCK * block;
    }
    ++head;
    bins[BLOCKS_START + head] = splat;
    bins[at] = head;
}

uint head_at(uint level, uvec2 at, uint run) {
    return HEADS_START + tile_index(level, at) * BINNING_RUNS + run;
}

void main() {
    uint run = gl_GlobalInvocationID.x;
    if (run == 0u) {
        control.fragments = 0u;
    }
    uint length = (control.visible_count + BINNING_RUNS - 1u) / BINNING_RUNS;
    uint end = min((run + 1u) * length, control.visible_count);
    // The next block of the run's own list for the whole image.
    uint image_block = BLOCKS + 1u + run * ((length + SPLATS_PER_BLOCK - 1u) / SPLATS_PER_BLOCK);
    // From far to near: the splat that is pushed last is the nearest.
    for (uint number = run * length; number < end; ++number) {
        uint i = order[number];
        Splat splat = unpack_splat(splats[i]);
        vec2 box = half_box(splat, radius_of(splat.opacity));
        uvec2 low = uvec2(0u);
        uvec2 high = uvec2(0u);
        uint block = 0u;
        uint level = 0u;
        for (; level < LAST_LEVEL; ++level) {
            float side = frame.tile_side * float(1u << 2u * level);
            float last = float((TILES_PER_SIDE >> 2u * level) - 1u);
            low = uvec2(clamp((splat.center - box) / side, 0.0, last));
            high = uvec2(clamp((splat.center + box) / side, 0.0, last));
            if ((high.x - low.x + 1u) * (high.y - low.y + 1u) > BINNING_TILES_MAX) {
                continue;
            }
            uint needed = 0u;
            for (uint y = low.y; y <= high.y; ++y) {
                for (uint x = low.x; x <= high.x; ++x) {
                    needed += needs_block(bins[head_at(level, uvec2(x, y), run)]) ? 1u : 0u;
                }
            }
            block = needed > 0u ? atomicAdd(bins[0], needed) + 1u : 1u;
            if (block + needed <= BLOCKS + 1u) {
                break;
            }
        }
        if (level == LAST_LEVEL) {
            low = uvec2(0u);
            high = uvec2(0u);
            block = image_block;
            image_block += needs_block(bins[head_at(LAST_LEVEL, low, run)]) ? 1u : 0u;
        }
        for (uint y = low.y; y <= high.y; ++y) {
            for (uint x = low.x; x <= high.x; ++x) {
                uint at = head_at(level, uvec2(x, y), run);
                uint head = bins[at];
                if (head == 0u) {
                    atomicOr(bins[RUNS_START + tile_index(level, uvec2(x, y))], 1u << run);
                }
                push(i, at, head, block);
                block += needs_block(head) ? 1u : 0u;
            }
        }
    }
}
