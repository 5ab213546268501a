// Which splats meet which tile of the picture: what `bins` writes and the compute form of `raster` reads.
//
// The picture is cut into at most BINS_SIDE by BINS_SIDE tiles, the drawing order into BINS_BLOCKS blocks of neighbours. A tile has a
// chain of nodes for each block. Splats that meet many tiles, and those for which there are no nodes left, go to a chain that the block
// has for the whole picture. So the memory has a bound whatever the splats are like, and nothing is left out.
//
//   word 0            nodes taken
//   word 1            blocks with a chain for the whole picture, a bit each
//   BINS_WIDE         where those chains start, a block each
//   BINS_MET          blocks that the tile has a chain of, a bit each
//   BINS_HEADS        where those chains start, tile by tile
//   BINS_NODES        nodes of BINS_NODE words: where the chain goes on, and splats, the nearest last
//
// Where a chain starts or goes on is the number of a node, from 1 up, times BINS_NODE, and how many splats the node has; 0 at the end.
const uint BINS_TILES = BINS_SIDE * BINS_SIDE;
const uint BINS_WIDE = 2u;
const uint BINS_MET = BINS_WIDE + BINS_BLOCKS;
const uint BINS_HEADS = BINS_MET + BINS_TILES;
// Node 0 is none.
const uint BINS_NODES = BINS_HEADS + BINS_TILES * BINS_BLOCKS - BINS_NODE;
const uint BINS_HELD = BINS_NODE - 1u;

// Half the sides of the box around a splat's ellipse, px. It reaches `reach` standard deviations.
vec2 half_box(Splat splat, float reach) {
    float steep = splat.shorter * inversesqrt(dot(splat.axis, splat.axis));
    return reach * sqrt(splat.axis * splat.axis + steep * steep * splat.axis.yx * splat.axis.yx);
}
