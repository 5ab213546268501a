//! A way to draw: everything in a renderer's options that is left to measurement.

use crate::{
    quirks::leaves_loops,
    vulkan::{
        device::{error::Result, gpu::Gpu, sort_choice::Outcome},
        raster::resolved,
        sort::choice,
    },
};
use effigy_core::{
    avatar::Avatar,
    frame::{ColorFormat, RasterMethod, RendererOptions, Skip, SortVariant},
};
use serde::{Deserialize, Serialize};
use std::fmt;

/// A way to draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Candidate {
    /// How splats are rasterized.
    pub method: RasterMethod,
    /// Whether quads are tested against the saturation depth.
    pub depth: bool,
    /// Format of the image.
    pub color: ColorFormat,
    /// How to sort.
    pub sort: SortVariant,
}

impl Candidate {
    /// The candidate that is drawn with while nothing is measured: the one recommended for the kind
    /// of device, with the sort that [`choice::without_test`] names.
    pub(crate) fn safest(gpu: &Gpu, options: &RendererOptions) -> Result<Self> {
        let resolved = resolved(gpu, *options);
        let method = resolved.method.unwrap_or(RasterMethod::Quads);
        Ok(Self {
            method,
            depth: method == RasterMethod::Quads && resolved.skip.contains(Skip::DEPTH),
            color: resolved.color.unwrap_or(method.color()),
            sort: match options.sort {
                Some(sort) => sort,
                None => choice::without_test(gpu)?,
            },
        })
    }

    /// Options that draw this way, and are otherwise `options`.
    pub fn apply(&self, options: RendererOptions) -> RendererOptions {
        let mut skip = options.skip;
        if self.method == RasterMethod::Quads && !self.depth {
            skip -= Skip::DEPTH;
        }
        RendererOptions {
            method: Some(self.method),
            color: Some(self.color),
            sort: Some(self.sort),
            skip,
            ..options
        }
    }

    /// The rasterizer's name, as `--raster` spells it where it has a spelling.
    pub fn raster(&self) -> String {
        if self.depth {
            "quads with saturation depth".into()
        } else {
            self.method.name().into()
        }
    }
}

impl fmt::Display for Candidate {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let color = match self.color {
            ColorFormat::Rgba8 => "RGBA8",
            ColorFormat::Rgba16F => "RGBA16F",
        };
        write!(f, "{}, {color}, {} sort", self.raster(), self.sort.name())
    }
}

/// What candidates of one group differ in. Axes are measured one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Axis {
    /// Method and saturation depth.
    Raster,
    /// Colour format.
    Color,
    /// Sort variant.
    Sort,
}

impl Axis {
    /// Every axis, in the order in which they are measured: what decides most comes first.
    pub const ALL: [Self; 3] = [Self::Raster, Self::Color, Self::Sort];

    /// Whether two candidates are the same in what the axis varies.
    pub fn is_same(self, a: &Candidate, b: &Candidate) -> bool {
        match self {
            Self::Raster => a.raster() == b.raster(),
            Self::Color => a.color == b.color && a.method == b.method,
            Self::Sort => a.sort == b.sort,
        }
    }
}

/// What there is to choose from: what a device can do, and what the options leave open.
#[derive(Clone, Debug, PartialEq)]
pub struct Choices {
    /// Ways to rasterize: method, saturation depth. The other fields are ignored.
    pub rasters: Vec<Candidate>,
    /// The colour format, where it is not left open.
    pub fixed_color: Option<ColorFormat>,
    /// Sort variants that passed the self-test; empty where the sort is not left open.
    pub sorts: Vec<SortVariant>,
}

impl Choices {
    /// Tests the device's sorts, if nobody did.
    pub(crate) fn new(
        gpu: &std::sync::Arc<Gpu>,
        options: &RendererOptions,
        safest: &Candidate,
    ) -> Result<Self> {
        let mut sorts = Vec::new();
        if options.sort.is_none() {
            let tried = choice::choose(gpu)?.tried;
            let right = tried
                .iter()
                .filter(|tested| matches!(tested.outcome, Outcome::Right(_)));
            sorts.extend(right.map(|tested| tested.variant));
        }
        Ok(Self {
            rasters: rasters(gpu, options, safest),
            fixed_color: options.color,
            sorts,
        })
    }

    /// The candidates of an axis besides the best so far.
    pub fn candidates(&self, axis: Axis, best: &Candidate) -> Vec<Candidate> {
        let all: Vec<Candidate> = match axis {
            Axis::Raster => self
                .rasters
                .iter()
                .map(|raster| Candidate {
                    color: self.fixed_color.unwrap_or(raster.method.color()),
                    sort: best.sort,
                    ..*raster
                })
                .collect(),
            Axis::Color if self.fixed_color.is_some() => Vec::new(),
            Axis::Color => [ColorFormat::Rgba8, ColorFormat::Rgba16F]
                .map(|color| Candidate { color, ..*best })
                .into(),
            Axis::Sort => self
                .sorts
                .iter()
                .map(|&sort| Candidate { sort, ..*best })
                .collect(),
        };
        all.into_iter()
            .filter(|candidate| !axis.is_same(candidate, best))
            .collect()
    }
}

/// The ways to rasterize that a device can take and options leave open.
fn rasters(gpu: &Gpu, options: &RendererOptions, safest: &Candidate) -> Vec<Candidate> {
    let mut rasters = Vec::new();
    if options.method.is_none() && gpu.probe.draws_triangles() {
        let quads = Candidate {
            method: RasterMethod::Quads,
            depth: false,
            ..*safest
        };
        rasters.push(quads);
        if options.skip.contains(Skip::DEPTH) {
            rasters.push(Candidate {
                depth: true,
                ..quads
            });
        }
    }
    if options.method.is_none() && !leaves_loops(&gpu.probe.driver) {
        let tiles = RasterMethod::ALL
            .into_iter()
            .filter(|method| method.is_tiles());
        let able = tiles.filter(|method| gpu.probe.lacks_for(*method).is_none());
        rasters.extend(able.map(|method| Candidate {
            method,
            depth: false,
            ..*safest
        }));
    }
    rasters
}

/// What is drawn, as far as it decides which candidate is fastest. Sizes are powers of two, so that
/// a window that is a little larger is not measured again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Workload {
    /// Gaussians of all avatars of a scene.
    pub gaussians: u64,
    /// Pixels of the image.
    pub pixels: u64,
    /// [`Skip`]: how it is written.
    pub skip: String,
    /// Bits of a sort key.
    pub key_bits: u32,
    /// What the options do not leave open, as they name it.
    pub fixed: String,
}

impl Workload {
    /// What a renderer of an avatar with these options draws.
    pub fn new(avatar: &Avatar, options: &RendererOptions) -> Self {
        let fixed = [
            options.method.map(|method| method.name().to_owned()),
            options.color.map(|color| format!("{color:?}")),
            options.sort.map(|sort| sort.name().to_owned()),
        ];
        let fixed: Vec<String> = fixed.into_iter().flatten().collect();
        let pixels = options.size.map(u64::from).iter().product();
        Self {
            gaussians: rounded((avatar.gaussians.len() * options.instances) as u64),
            pixels: rounded(pixels),
            skip: options.skip.to_string(),
            key_bits: options.keys().bits(),
            fixed: fixed.join(", "),
        }
    }

    /// Whether options leave anything to measure.
    pub fn is_open(options: &RendererOptions) -> bool {
        options.method.is_none() || options.color.is_none() || options.sort.is_none()
    }
}

/// The nearest power of two, by ratio.
fn rounded(number: u64) -> u64 {
    1 << (number.max(1) as f64).log2().round() as u32
}

impl fmt::Display for Workload {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(
            f,
            "about {} Gaussians on {} px, keys of {} bits",
            self.gaussians, self.pixels, self.key_bits
        )?;
        if !self.fixed.is_empty() {
            write!(f, ", with {}", self.fixed)?;
        }
        if self.skip != Skip::all().to_string() {
            write!(f, ", skipping {}", self.skip)?;
        }
        Ok(())
    }
}
