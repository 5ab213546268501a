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
    frame::{ColorFormat, RasterMethod, RendererOptions, Skip, SortVariant, TileKernel},
    layout::{PROJECT_WORKGROUP, PROJECT_WORKGROUPS},
};
use serde::{Deserialize, Serialize};
use std::fmt;

/// A way to draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Candidate {
    /// How splats are rasterized.
    pub method: RasterMethod,
    /// The kernel of [`RasterMethod::Tiles`]; the device's own with quads.
    pub kernel: TileKernel,
    /// Whether quads are tested against the saturation depth.
    pub depth: bool,
    /// Format of the image.
    pub color: ColorFormat,
    /// How to sort.
    pub sort: SortVariant,
    /// Whether f16 is read as words.
    pub packed_words: bool,
    /// Invocations of a workgroup of the `project` stage.
    pub workgroup: u32,
}

impl Candidate {
    /// The candidate that is drawn with while nothing is measured: the one recommended for the kind
    /// of device, with the sort that [`choice::without_test`] names.
    pub(crate) fn safest(gpu: &Gpu, options: &RendererOptions) -> Result<Self> {
        let resolved = resolved(gpu, *options);
        let method = resolved.method.unwrap_or(RasterMethod::Quads);
        Ok(Self {
            method,
            kernel: resolved.kernel.unwrap_or(TileKernel::PerThread),
            depth: method == RasterMethod::Quads && resolved.skip.contains(Skip::DEPTH),
            color: resolved.color.unwrap_or(method.color()),
            sort: match options.sort {
                Some(sort) => sort,
                None => choice::without_test(gpu)?,
            },
            packed_words: resolved.packed_words == Some(true),
            workgroup: resolved.workgroup.unwrap_or(PROJECT_WORKGROUP),
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
            kernel: Some(self.kernel),
            color: Some(self.color),
            sort: Some(self.sort),
            packed_words: Some(self.packed_words),
            workgroup: Some(self.workgroup),
            skip,
            ..options
        }
    }

    /// The rasterizer's name, as `--raster` spells it where it has a spelling.
    pub fn raster(&self) -> String {
        match (self.method, self.depth) {
            (RasterMethod::Tiles, _) => format!("tiles-{}", self.kernel.name()),
            (RasterMethod::Quads, true) => "quads with saturation depth".into(),
            (RasterMethod::Quads, false) => "quads".into(),
        }
    }
}

impl fmt::Display for Candidate {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let color = match self.color {
            ColorFormat::Rgba8 => "RGBA8",
            ColorFormat::Rgba16F => "RGBA16F",
        };
        let storage = if self.packed_words { "words" } else { "f16" };
        let raster = self.raster();
        write!(
            f,
            "{raster}, {color}, {} sort, {storage}, workgroups of {}",
            self.sort.name(),
            self.workgroup
        )
    }
}

/// What candidates of one group differ in. Axes are measured one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Axis {
    /// Method, kernel and saturation depth.
    Raster,
    /// Colour format.
    Color,
    /// Sort variant.
    Sort,
    /// How f16 is read.
    Storage,
    /// Size of workgroups.
    Workgroup,
}

impl Axis {
    /// Every axis, in the order in which they are measured: what decides most comes first.
    pub const ALL: [Self; 5] = [
        Self::Raster,
        Self::Color,
        Self::Sort,
        Self::Storage,
        Self::Workgroup,
    ];

    /// Whether two candidates are the same in what the axis varies.
    pub fn is_same(self, a: &Candidate, b: &Candidate) -> bool {
        match self {
            Self::Raster => a.raster() == b.raster(),
            Self::Color => a.color == b.color && a.method == b.method,
            Self::Sort => a.sort == b.sort,
            Self::Storage => a.packed_words == b.packed_words,
            Self::Workgroup => a.workgroup == b.workgroup,
        }
    }
}

/// What there is to choose from: what a device can do, and what the options leave open.
#[derive(Clone, Debug, PartialEq)]
pub struct Choices {
    /// Ways to rasterize: method, kernel, saturation depth. The other fields are ignored.
    pub rasters: Vec<Candidate>,
    /// The colour format, where it is not left open.
    pub fixed_color: Option<ColorFormat>,
    /// Sort variants that passed the self-test; empty where the sort is not left open.
    pub sorts: Vec<SortVariant>,
    /// Whether both forms of f16 can be read, and which is left open.
    pub both_storages: bool,
    /// Sizes of workgroups; empty where it is not left open.
    pub workgroups: Vec<u32>,
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
            both_storages: gpu.half_storage && options.packed_words.is_none(),
            workgroups: if options.workgroup.is_none() {
                PROJECT_WORKGROUPS.into()
            } else {
                Vec::new()
            },
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
                    packed_words: best.packed_words,
                    workgroup: best.workgroup,
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
            Axis::Storage if !self.both_storages => Vec::new(),
            Axis::Storage => [false, true]
                .map(|packed_words| Candidate {
                    packed_words,
                    ..*best
                })
                .into(),
            Axis::Workgroup => self
                .workgroups
                .iter()
                .map(|&workgroup| Candidate { workgroup, ..*best })
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
    let open = options.method != Some(RasterMethod::Quads) && options.kernel.is_none();
    if open && !leaves_loops(&gpu.probe.driver) {
        for kernel in TileKernel::ALL {
            if gpu.probe.lacks_for(kernel).is_none() {
                rasters.push(Candidate {
                    method: RasterMethod::Tiles,
                    kernel,
                    depth: false,
                    ..*safest
                });
            }
        }
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
            options.kernel.map(|kernel| kernel.name().to_owned()),
            options.color.map(|color| format!("{color:?}")),
            options.sort.map(|sort| sort.name().to_owned()),
            options.packed_words.map(|words| format!("words {words}")),
            options
                .workgroup
                .map(|size| format!("workgroups of {size}")),
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
        options.method.is_none()
            || options.color.is_none()
            || options.sort.is_none()
            || options.packed_words.is_none()
            || options.workgroup.is_none()
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
