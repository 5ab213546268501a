// Tile binning: which splats touch which tile. `binning` writes it; the compute form of `raster`
// reads it.
//
// The image is cut into at most TILES_PER_SIDE by TILES_PER_SIDE tiles. Each of the TILE_LEVELS
// levels has a sixteenth of the tiles of the one before; the last is one tile, the whole image. A
// splat goes into the tiles that it touches at the first level where these are at most
// BINNING_TILES_MAX. The drawing order is cut into BINNING_RUNS runs, and a tile has a list of
// blocks for each run. If the blocks run out, the next level takes the splat, and the last level
// has blocks of its own. So memory is bounded, a tile has few splats that do not touch it, and none
// is lost.
//
//   word 0          blocks in use
//   RUNS_START      a mask for each tile: the runs for which it has a list
//   HEADS_START     the head of each list, tile by tile
//   BLOCKS_START    blocks of BINNING_BLOCK words: a link to the next, and splats, the nearest last
//
// A head or a link is the number of a block, from 1 up, times BINNING_BLOCK, plus the count of
// splats in that block. 0 ends a list.
const uint RUNS_START = 1u;
const uint HEADS_START = RUNS_START + TILE_COUNT;
// Block 0 does not exist.
const uint BLOCKS_START = HEADS_START + TILE_COUNT * BINNING_RUNS - BINNING_BLOCK;
const uint SPLATS_PER_BLOCK = BINNING_BLOCK - 1u;
const uint LAST_LEVEL = TILE_LEVELS - 1u;

// Index of a level's tile, from its column and row.
uint tile_index(uint level, uvec2 at) {
    const uint finest = TILES_PER_SIDE * TILES_PER_SIDE;
    return (finest - (finest >> 4u * level)) / 15u * 16u +
           at.y * (TILES_PER_SIDE >> 2u * level) + at.x;
}

// Half the sides of the box around a splat's ellipse of `radius` standard deviations, px.
vec2 half_box(Splat splat, float radius) {
    float steep = splat.shorter * inversesqrt(dot(splat.axis, splat.axis));
    return radius * sqrt(splat.axis * splat.axis + steep * steep * splat.axis.yx * splat.axis.yx);
}
