// Which splats meet which tile of the picture: what `bins` writes and the compute form of `raster` reads.
//
// The picture is cut into at most FINEST by FINEST tiles, those into coarser ones of four by four, those again, and last comes one
// tile that is the whole picture: BINS_LEVELS levels. A splat is put into the tiles that it meets at the first level where they are few.
// The drawing order is cut into BINS_BLOCKS blocks of neighbours, and a tile has a chain of nodes for each block. Where there are no
// nodes left, the next level needs fewer, and the last has its own. So the memory has a bound whatever the splats are like, a tile has
// few splats that do not meet it, and nothing is left out.
//
//   word 0            nodes taken
//   BINS_MET          blocks that the tile has a chain of, a bit each
//   BINS_HEADS        where those chains start, tile by tile
//   BINS_NODES        nodes of BINS_NODE words: where the chain goes on, and splats, the nearest last
//
// Where a chain starts or goes on is the number of a node, from 1 up, times BINS_NODE, and how many splats the node has; 0 at the end.
#ifdef WEB
const uint FINEST = BINS_WEB_SIDE, ALL_TILES = BINS_WEB_TILES;
#else
const uint FINEST = BINS_SIDE, ALL_TILES = BINS_TILES;
#endif
const uint BINS_MET = 1u;
const uint BINS_HEADS = BINS_MET + ALL_TILES;
// Node 0 is none.
const uint BINS_NODES = BINS_HEADS + ALL_TILES * BINS_BLOCKS - BINS_NODE;
const uint BINS_HELD = BINS_NODE - 1u;
const uint BINS_WHOLE = BINS_LEVELS - 1u;

// The number of a level's tile, at its column and row there. Each level has a sixteenth of the tiles of the one before.
uint bins_tile(uint level, uvec2 at) {
    const uint finest = FINEST * FINEST;
    return (finest - (finest >> 4u * level)) / 15u * 16u + at.y * (FINEST >> 2u * level) + at.x;
}

// Half the sides of the box around a splat's ellipse, px. It reaches `reach` standard deviations.
vec2 half_box(Splat splat, float reach) {
    float steep = splat.shorter * inversesqrt(dot(splat.axis, splat.axis));
    return reach * sqrt(splat.axis * splat.axis + steep * steep * splat.axis.yx * splat.axis.yx);
}
