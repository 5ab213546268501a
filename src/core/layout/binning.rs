//! Tile sizes and the memory of the tiles' lists.

use super::{BINNING_BLOCK, BINNING_RUNS, TILE_LEVELS};

/// How images are cut into tiles.
pub const TILING: TileGrid = TileGrid {
    tiles_per_side: 128,
    min_tile: 16,
    blocks_per_splat: 1,
};

/// How images are cut into tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TileGrid {
    /// Maximum number of tiles along each side of an image; a power of two.
    pub tiles_per_side: u32,
    /// Side of the smallest tile, px.
    pub min_tile: u32,
    /// The most blocks of the tiles' lists for each splat.
    pub blocks_per_splat: u32,
}

/// Shared list blocks that are worth waiting for other lists: half a megabyte.
const BLOCKS_WORTH: u32 = 1 << 14;

impl TileGrid {
    /// Side of a tile in an image of a size, px: the smallest power of two with which
    /// [`Self::tiles_per_side`] is not exceeded.
    pub fn tile(self, size: [u32; 2]) -> u32 {
        size[0]
            .max(size[1])
            .div_ceil(self.tiles_per_side)
            .max(self.min_tile)
            .next_power_of_two()
    }

    /// Index of a level's first tile. Each level has a sixteenth of the tiles of the level before
    /// it (`shaders/common/tiles.glsl`).
    pub const fn first_tile(self, level: u32) -> u32 {
        let finest = self.tiles_per_side * self.tiles_per_side;
        (finest - (finest >> (4 * level))) / 15 * 16
    }

    /// Number of tiles of all levels.
    pub const fn tiles(self) -> u32 {
        self.first_tile(TILE_LEVELS - 1) + 1
    }

    /// The most list blocks for this many splats that all levels but the last share. With fewer,
    /// more splats go to larger tiles.
    pub fn most_blocks(self, capacity: u32) -> u32 {
        capacity
            .saturating_mul(self.blocks_per_splat)
            .saturating_add(4096)
    }

    /// Shared list blocks that suffice where splats are those of bodies: with tiles of 16 px one of
    /// 200,000 Gaussians and 2000 px asks for up to 111,000, four of them for 261,000. The most
    /// where that is hardly more.
    pub fn few_blocks(self, capacity: u32) -> u32 {
        let most = self.most_blocks(capacity);
        let few = 4096 + capacity / 4 + (capacity / 2).min(160_000);
        if most.saturating_sub(few) < BLOCKS_WORTH {
            most
        } else {
            few
        }
    }

    /// Shared list blocks for the frames that follow one that asked for `asked`, where there were
    /// `blocks`: the most once they are all but used up, since what finds none costs much time; few
    /// while half of those would do. None where nothing changes.
    pub fn other_blocks(self, capacity: u32, blocks: u32, asked: u32) -> Option<u32> {
        let [few, most] = [self.few_blocks(capacity), self.most_blocks(capacity)];
        let other = if asked > blocks / 8 * 7 {
            most
        } else if asked < few / 4 * 3 {
            few
        } else {
            blocks
        };
        (other != blocks).then_some(other)
    }

    /// Bytes of the lists' heads and counts (`shaders/common/tiles.glsl`).
    pub fn head_bytes(self) -> u64 {
        let tiles = u64::from(self.tiles());
        4 * (1 + tiles + tiles * u64::from(BINNING_RUNS))
    }

    /// Bytes of the lists of this many splats, with `blocks` shared blocks and those of the last
    /// level.
    pub fn bytes(self, capacity: u32, blocks: u32) -> u64 {
        let last_level = BINNING_RUNS * capacity.div_ceil(BINNING_RUNS).div_ceil(BINNING_BLOCK - 1);
        let blocks = u64::from(blocks) + u64::from(last_level);
        self.head_bytes() + 4 * u64::from(BINNING_BLOCK) * blocks
    }
}

#[cfg(test)]
mod tests {
    use super::TILING;

    #[test]
    fn blocks_are_few_where_frames_ask_for_few() {
        let [few, most] = [TILING.few_blocks(200_000), TILING.most_blocks(200_000)];
        let other = |blocks, asked| TILING.other_blocks(200_000, blocks, asked);
        assert_eq!(other(most, 111_000), Some(few));
        assert_eq!(other(few, 111_000), None);
        assert_eq!(other(few, few), Some(most));
        // Between the two nothing swings.
        assert_eq!(other(most, few / 8 * 7), None);
        assert_eq!(other(few, few / 8 * 7), None);
        assert_eq!(other(most, u32::MAX), None);
        assert_eq!(TILING.few_blocks(5000), TILING.most_blocks(5000));
        // Four bodies.
        assert!(TILING.few_blocks(800_000) / 4 * 3 > 261_000);
    }

    #[test]
    fn tiles_are_as_small_as_their_maximum_number_allows() {
        let sides = [1, 1024, 1025, 2048, 2049, 8192].map(|side| TILING.tile([1, side]));
        assert_eq!(sides, [16, 16, 16, 16, 32, 64]);
    }

    #[test]
    fn tiles_of_all_levels_follow_each_other() {
        let level = |level: u32| (TILING.tiles_per_side >> (2 * level)).pow(2);
        assert_eq!(
            [0, 1, 2, 3].map(|k| TILING.first_tile(k)),
            [
                0,
                level(0),
                level(0) + level(1),
                level(0) + level(1) + level(2)
            ]
        );
        assert_eq!(TILING.tiles(), TILING.first_tile(3) + 1);
    }
}
