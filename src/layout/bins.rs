//! How the picture is cut into tiles, and the memory that their chains of splats take.

use super::{BINS_BLOCKS, BINS_NODE, BINS_SIDE, BINS_TILE, BINS_TILES};

/// Nodes of the tiles' chains for so many splats, and all nodes. A 200K body 2000 pixels high takes a node for every second splat.
pub fn nodes(capacity: u32) -> [u32; 2] {
    let narrow = capacity.saturating_add(4096);
    [narrow, narrow.saturating_add(BINS_BLOCKS * capacity.div_ceil(BINS_BLOCKS).div_ceil(BINS_NODE - 1))]
}

/// The side of a tile in a picture, px: the smallest power of two that makes at most [`BINS_SIDE`] tiles along each side.
pub fn tile(size: [u32; 2]) -> u32 {
    tile_of_at_least(BINS_TILE, size)
}

/// The same with another smallest side, px.
pub fn tile_of_at_least(least: u32, size: [u32; 2]) -> u32 {
    size[0].max(size[1]).div_ceil(BINS_SIDE).max(least).next_power_of_two()
}

/// The number of a level's first tile: the levels before have a sixteenth each of the tiles of the one before (`shaders/bins.glsl`).
pub const fn first_tile(level: u32) -> u32 {
    let finest = BINS_SIDE * BINS_SIDE;
    (finest - (finest >> (4 * level))) / 15 * 16
}

/// Bytes of the bins before their nodes, and of all (`shaders/bins.glsl`).
pub fn bins_size(capacity: u32) -> [u64; 2] {
    let (tiles, blocks) = (u64::from(BINS_TILES), u64::from(BINS_BLOCKS));
    let heads = 4 * (1 + tiles + tiles * blocks);
    [heads, heads + 4 * u64::from(BINS_NODE) * u64::from(nodes(capacity)[1])]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_are_as_small_as_their_number_allows() {
        let sides = [1, 1024, 1025, 2048, 2049, 8192].map(|side| tile([1, side]));
        assert_eq!(sides, [16, 16, 16, 16, 32, 64]);
        assert_eq!([1024, 1025, 2049].map(|side| tile_of_at_least(8, [1, side])), [8, 16, 32]);
    }
}
