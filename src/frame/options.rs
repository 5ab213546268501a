//! What a renderer is made with: everything that trades time or memory for something else.

use super::{ALPHA_MIN, Detail, KeyBits, Skip};
use crate::layout::{SORT_CHAIN_TILE, SORT_DIGITS, SORT_GROUP, SORT_LANES, SORT_STATE, SORT_TILE};
use serde::{Deserialize, Serialize};

/// What a renderer is made with.
#[derive(Clone, Copy, Debug)]
pub struct RendererOptions {
    /// Width and height of the picture, px.
    pub size: [u32; 2],
    /// What the picture is stored in. None: as suits the method, 8 bits where each pixel is rounded once.
    pub color: Option<ColorFormat>,
    /// How splats are drawn. None: as suits the device.
    pub method: Option<Method>,
    pub key_bits: KeyBits,
    /// How to sort. None: as the self-test finds best.
    pub sort: Option<Variant>,
    /// What is left out where the scene doesn't need it.
    pub skip: Skip,
    /// Contributions below this opacity are not drawn, at least 1/255 (model.md, step 10).
    pub cutoff: f64,
    /// How far behind the depth surface something is hidden, metres.
    pub margin: f64,
    /// How many of an avatar's Gaussians are drawn.
    pub detail: Detail,
    /// Copies of the avatar that a scene may have, at least 1: memory grows with it.
    pub actors: usize,
    /// Count fragments, where the device can, and why Gaussians are left out: for measurements, since some devices are slower then.
    pub count: bool,
}

impl RendererOptions {
    /// The defaults at a size.
    pub fn new(size: [u32; 2]) -> Self {
        Self {
            size,
            color: None,
            method: None,
            key_bits: KeyBits::default(),
            sort: None,
            skip: Skip::all() - Skip::DEPTH,
            cutoff: ALPHA_MIN,
            margin: 0.005,
            detail: Detail::FULL,
            actors: 1,
            count: false,
        }
    }
}

/// What the picture is blended or stored in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColorFormat {
    /// 8 bits a channel: 4 bytes a pixel, rounded after every Gaussian by [`Method::Hulls`], once by [`Method::Tiles`].
    Rgba8,
    /// 16-bit floating point: 8 bytes a pixel.
    #[default]
    Rgba16F,
}

impl ColorFormat {
    /// Bytes of a pixel.
    pub fn bytes(self) -> usize {
        match self {
            Self::Rgba8 => 4,
            Self::Rgba16F => 8,
        }
    }
}

/// How splats become a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Quads through the graphics pipeline: tilers blend them in their tile memory.
    Hulls,
    /// A compute kernel over tiles of the picture, which stops where a pixel is full.
    Tiles,
}

impl Method {
    pub const ALL: [Self; 2] = [Self::Hulls, Self::Tiles];

    pub fn name(self) -> &'static str {
        match self {
            Self::Hulls => "hulls",
            Self::Tiles => "tiles",
        }
    }

    /// What the picture is stored in unless told otherwise.
    pub fn color(self) -> ColorFormat {
        match self {
            Self::Hulls => ColorFormat::Rgba16F,
            Self::Tiles => ColorFormat::Rgba8,
        }
    }

    /// What is faster on a kind of device, as far as it was measured (NOTES.md): processors gain from every fragment that is left out.
    /// `device`: its name, see [`draws_triangles`]. `driver`: its name and build as it tells them. Some play the tiles' kernels wrongly.
    pub fn suited(is_cpu: bool, device: &str, driver: &str) -> Self {
        if (is_cpu && !leaves_loops(driver)) || !draws_triangles(device) { Self::Tiles } else { Self::Hulls }
    }
}

/// Whether a device draws triangles, by its name. llvmpipe at 512 bits ends the program that does: any program, with Mesa 22.3 and 25.0.
pub fn draws_triangles(device: &str) -> bool {
    !(device.starts_with("llvmpipe") && device.contains(" 512 bits"))
}

/// What a device lacks, and what to do, where [`draws_triangles`] is false.
pub(crate) const NO_TRIANGLES: &str = "its driver crashes when it draws triangles with vectors of 512 bits: set LP_NATIVE_VECTOR_WIDTH=256, or use `--raster tiles` and no window";

/// Whether a driver leaves an invocation's loops after 65,535 rounds of all of them together, as llvmpipe did. Seen with Mesa 22.3, not with
/// 25.0; between them it was not tried.
pub(crate) fn leaves_loops(driver: &str) -> bool {
    let number = |text: &str| text.split(|c: char| !c.is_ascii_digit()).next().and_then(|digits| digits.parse::<u32>().ok());
    driver.starts_with("llvmpipe") && driver.split_once("Mesa ").and_then(|(_, version)| number(version)).is_none_or(|version| version < 25)
}

/// How to sort.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Variant {
    OneSweep,
    SelfScan,
    LaneScan,
}

impl Variant {
    pub const ALL: [Self; 3] = [Self::OneSweep, Self::SelfScan, Self::LaneScan];

    pub fn name(self) -> &'static str {
        match self {
            Self::OneSweep => "OneSweep",
            Self::SelfScan => "self-scan",
            Self::LaneScan => "lane-scan",
        }
    }

    /// Keys of a tile, which a workgroup takes.
    pub fn tile(self) -> u32 {
        match self {
            Self::OneSweep => SORT_CHAIN_TILE,
            Self::SelfScan => SORT_TILE,
            Self::LaneScan => 1024 * SORT_LANES,
        }
    }

    /// Bytes of the counts of a sort of so many tiles (`shaders/sort.glsl` says where what is).
    pub fn counts_size(self, tiles: u32) -> u64 {
        let (tiles, groups) = (u64::from(tiles), u64::from(tiles.div_ceil(SORT_GROUP)));
        let areas = match self {
            Self::OneSweep => 2 * tiles,
            Self::SelfScan => 0,
            Self::LaneScan => u64::from(SORT_LANES + 1) * tiles,
        };
        4 * (u64::from(SORT_DIGITS) * (tiles + 3 + groups + areas) + u64::from(SORT_STATE))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_are_for_processors_whose_driver_plays_them() {
        for (driver, method) in [
            ("llvmpipe Mesa 25.0.7 (LLVM 15.0.6)", Method::Tiles),
            ("llvmpipe Mesa 26.1.0-devel (git-0123456789)", Method::Tiles),
            ("llvmpipe Mesa 22.3.6 (LLVM 15.0.6)", Method::Hulls),
            ("llvmpipe", Method::Hulls),
            ("SwiftShader driver", Method::Tiles),
        ] {
            assert_eq!(Method::suited(true, "llvmpipe (LLVM 15.0.6, 256 bits)", driver), method, "{driver}");
        }
        assert_eq!(Method::suited(false, "NVIDIA H200", "NVIDIA 570.1"), Method::Hulls);
        assert_eq!(Method::suited(true, "llvmpipe (LLVM 15.0.6, 512 bits)", "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"), Method::Tiles);
    }
}
