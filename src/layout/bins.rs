//! How the picture is cut into tiles, and the memory that their chains of splats take.

use super::{BINS_BLOCKS, BINS_LEVELS, BINS_NODE};

/// How a backend cuts pictures into tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tiling {
    /// Tiles along each side of a picture, at most; a power of two.
    pub side: u32,
    /// Pixels along each side of the smallest tile.
    pub least: u32,
    /// Nodes of the tiles' chains for each splat. A 200K body 2000 pixels high takes one for every second splat with tiles of 16 pixels.
    pub nodes: u32,
}

impl Tiling {
    /// The side of a tile in a picture, px: the smallest power of two that makes at most so many tiles along each side.
    pub fn tile(self, size: [u32; 2]) -> u32 {
        size[0].max(size[1]).div_ceil(self.side).max(self.least).next_power_of_two()
    }

    /// The number of a level's first tile: the levels before have a sixteenth each of the tiles of the one before (`shaders/bins.glsl`).
    pub const fn first_tile(self, level: u32) -> u32 {
        let finest = self.side * self.side;
        (finest - (finest >> (4 * level))) / 15 * 16
    }

    /// Tiles of all levels.
    pub const fn tiles(self) -> u32 {
        self.first_tile(BINS_LEVELS - 1) + 1
    }

    /// Nodes of the tiles' chains for so many splats, and all nodes.
    pub fn nodes(self, capacity: u32) -> [u32; 2] {
        let narrow = capacity.saturating_mul(self.nodes).saturating_add(4096);
        [narrow, narrow.saturating_add(BINS_BLOCKS * capacity.div_ceil(BINS_BLOCKS).div_ceil(BINS_NODE - 1))]
    }

    /// Bytes of the bins before their nodes, and of all (`shaders/bins.glsl`).
    pub fn bytes(self, capacity: u32) -> [u64; 2] {
        let (tiles, blocks) = (u64::from(self.tiles()), u64::from(BINS_BLOCKS));
        let heads = 4 * (1 + tiles + tiles * blocks);
        [heads, heads + 4 * u64::from(BINS_NODE) * u64::from(self.nodes(capacity)[1])]
    }
}

#[cfg(test)]
mod tests {
    use crate::layout::{BINS, BINS_WEB};

    #[test]
    fn tiles_are_as_small_as_their_number_allows() {
        let sides = [1, 1024, 1025, 2048, 2049, 8192].map(|side| BINS.tile([1, side]));
        assert_eq!(sides, [16, 16, 16, 16, 32, 64]);
        assert_eq!([1024, 1025, 2048, 2049, 8192].map(|side| BINS_WEB.tile([1, side])), [8, 8, 8, 16, 32]);
    }

    #[test]
    fn tiles_of_all_levels_follow_each_other() {
        for tiling in [BINS, BINS_WEB] {
            let level = |level: u32| (tiling.side >> (2 * level)).pow(2);
            assert_eq!([0, 1, 2, 3].map(|k| tiling.first_tile(k)), [0, level(0), level(0) + level(1), level(0) + level(1) + level(2)]);
            assert_eq!(tiling.tiles(), tiling.first_tile(3) + 1);
        }
    }
}
