//! Arguments that several commands share, and how they are read.

use anyhow::Context;
use clap::{
    ValueEnum,
    builder::{PossibleValuesParser, RangedU64ValueParser, TypedValueParser},
};
use effigy_core::{
    avatar::{Avatar, Filter},
    frame::Skip,
    io::splats::Up,
    scene::{Camera, Detail, Framing, Supersampling},
};
use effigy_render::vulkan::{
    Gpu, GpuOptions, RendererOptions, raster::RasterMethod, sort::SortVariant,
};
use effigy_runtime::trace::TraceRecorder;
use glam::DVec3;
use std::path::Path;

/// Reads one of `values` by its name, for types of the libraries, which know nothing of a command
/// line. `names` are in the order of `values`.
pub fn named<T: Copy + Send + Sync + 'static, const N: usize>(
    names: [&'static str; N],
    values: [T; N],
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(names).map(move |name| {
        let index = names.iter().position(|known| *known == name);
        values[index.expect("clap accepts the names alone")]
    })
}

/// Reads a whole number from `min` to `max`.
pub fn count(min: usize, max: usize) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(min as u64..=max as u64)
}

/// Where the camera stands.
#[derive(clap::Args, Clone, Debug)]
pub struct CameraArgs {
    /// Angle around the avatar, degrees: 0 sees its front, 90 its left side
    #[arg(
        long,
        value_name = "DEGREES",
        default_value_t = 20.0,
        allow_negative_numbers = true
    )]
    pub yaw: f64,
    /// Angle above the horizon, degrees, -89 to 89
    #[arg(
        long,
        value_name = "DEGREES",
        default_value_t = 5.0,
        allow_negative_numbers = true
    )]
    pub pitch: f64,
    /// Distance from the avatar's centre, metres, above 0 [default: the whole avatar fits]
    #[arg(long, value_name = "METRES")]
    pub distance: Option<f64>,
    /// Height of the point looked at, metres above the avatar's centre
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 0.0,
        allow_negative_numbers = true
    )]
    pub raise: f64,
    /// Vertical field of view, degrees, 1 to 170
    #[arg(long, value_name = "DEGREES", default_value_t = 35.0)]
    pub fov: f64,
}

impl CameraArgs {
    /// The camera that looks at an avatar for an image of `size` pixels.
    pub fn camera(&self, framing: Framing, size: [u32; 2]) -> anyhow::Result<Camera> {
        anyhow::ensure!(
            (1.0..=170.0).contains(&self.fov),
            "a field of view of {}° can't be drawn: give --fov from 1 to 170",
            self.fov
        );
        let fov = self.fov.to_radians();
        let distance = self
            .distance
            .unwrap_or_else(|| Camera::framing_distance(framing.bounds, fov, size));
        let target = framing.middle() + self.raise * DVec3::Y;
        let yaw = self.yaw.to_radians();
        let pitch = self.pitch.clamp(-89.0, 89.0).to_radians();
        let camera = Camera {
            near: framing.near,
            ..Camera::orbit(target, yaw, pitch, distance, fov, size)
        };
        camera.check().context(
            "no camera has this view: give finite --yaw, --pitch, --distance and --raise",
        )?;
        Ok(camera)
    }
}

/// Which GPU a command runs on.
#[derive(clap::Args, Clone, Debug, PartialEq)]
pub struct DeviceArgs {
    /// GPU: part of its name, or its number in `effigy devices` [default: the first that can
    /// serve]
    #[arg(long = "device", value_name = "NAME")]
    pub name: Option<String>,
}

impl DeviceArgs {
    /// The options to open the GPU with, without a window.
    pub fn gpu(&self) -> GpuOptions {
        effigy_runtime::cache::headless(self.name.clone())
    }
}

/// The device, and how much error is traded for time.
#[derive(clap::Args, Clone, Debug)]
pub struct QualityArgs {
    #[command(flatten)]
    pub device: DeviceArgs,
    /// Skip and add nothing that changes the image by more than rounding, and store it in 16-bit
    /// floats: some 6 dB nearer to the reference, in a tenth more time
    #[arg(long, conflicts_with_all = ["cutoff", "detail", "supersample"])]
    pub exact: bool,
    /// Use no more of the device than the minimum specification has
    #[arg(long, alias = "least")]
    pub baseline: bool,
    /// Raster method
    #[arg(long, value_enum, default_value_t = RasterArg::Auto)]
    pub raster: RasterArg,
    /// Sort variant
    #[arg(long, value_enum, default_value_t = SortArg::Auto)]
    pub sort: SortArg,
    /// Work to skip where the scene does not need it: all, none, or names separated by commas
    /// [default: all]
    #[arg(long, value_name = "NAME,NAME")]
    pub skip: Option<Skip>,
    /// Opacity under which nothing is drawn, in 255ths, 1 to 255 [default: 1]
    #[arg(long, value_name = "N", value_parser = cutoff)]
    pub cutoff: Option<f64>,
    /// Share of an avatar's Gaussians to draw: full, 1/2, 1/4, 1/8, or auto, which draws fewer of
    /// avatars that are small in the image [default: full]
    #[arg(long, value_name = "SHARE")]
    pub detail: Option<Detail>,
    /// How many times its size to draw an avatar, before it is averaged: 1, 2, 4, or auto, which
    /// draws avatars larger that are small in the image [default: auto]
    #[arg(long, value_name = "FACTOR")]
    pub supersample: Option<Supersampling>,
    /// Most Gaussians that a frame draws, of all avatars together: where there are more, avatars
    /// with the most a pixel are drawn coarser [default: all; of more than 16 avatars as many as
    /// four have, with --exact all]
    #[arg(long, value_name = "N")]
    pub draw_at_most: Option<u32>,
    #[command(flatten)]
    pub filter: FilterArgs,
}

/// The axis that points up in splats, where a command's only avatar may be splats.
#[derive(clap::Args, Clone, Copy, Debug)]
pub struct UpArgs {
    /// Axis that points up in splats [default: the file's own, else its format's: y in .spz, .glb
    /// and .gltf, -y in others, as 3DGS trains]
    #[arg(long, value_parser = named(Up::NAMES, Up::ALL), value_name = "AXIS", allow_hyphen_values = true)]
    pub up: Option<Up>,
}

/// The low-pass that Gaussians are drawn with.
#[derive(clap::Args, Clone, Copy, Debug)]
pub struct FilterArgs {
    /// Low-pass that Gaussians are drawn with: its variance in square pixels, 0.1 to 10, with
    /// +compensated if the avatar was learned with compensated opacities, for instance
    /// 0.1+compensated [default: the avatar's own]
    #[arg(long = "filter", value_name = "VARIANCE", value_parser = filter)]
    chosen: Option<ChosenFilter>,
}

impl FilterArgs {
    /// The filter to draw with; None: the avatar's own.
    pub fn filter(self) -> Option<Filter> {
        match self.chosen {
            Some(ChosenFilter::Other(filter)) => Some(filter),
            Some(ChosenFilter::Own) | None => None,
        }
    }

    /// Gives an avatar that filter, for what draws it without a renderer's options.
    pub fn apply(self, avatar: &mut Avatar) {
        avatar.filter = self.filter().unwrap_or(avatar.filter);
    }
}

/// What `--filter` says.
#[derive(Clone, Copy, Debug)]
enum ChosenFilter {
    /// The avatar's.
    Own,
    Other(Filter),
}

/// Reads `--filter`.
fn filter(text: &str) -> Result<ChosenFilter, String> {
    match text {
        "own" => Ok(ChosenFilter::Own),
        _ => text.parse().map(ChosenFilter::Other),
    }
}

impl QualityArgs {
    /// The options to open the GPU with, without a window.
    pub fn gpu(&self) -> GpuOptions {
        GpuOptions {
            baseline: self.baseline,
            ..self.device.gpu()
        }
    }

    /// The options of a renderer for images of `size` pixels.
    pub fn renderer(&self, size: [u32; 2]) -> RendererOptions {
        let mut base = RendererOptions {
            skip: self.skip.unwrap_or(Skip::all()),
            ..RendererOptions::new(size)
        };
        if self.exact {
            base = base.exactly();
        }
        RendererOptions {
            method: self.raster.into(),
            sort: self.sort.into(),
            cutoff: self.cutoff.map_or(base.cutoff, |n| n / 255.0),
            detail: self.detail.unwrap_or(base.detail),
            supersampling: self.supersample.unwrap_or(base.supersampling),
            filter: self.filter.filter(),
            gaussians: self.draw_at_most.or(base.gaussians),
            ..base
        }
    }
}

/// Reads `--cutoff`, 255ths.
fn cutoff(text: &str) -> Result<f64, String> {
    number(text, 1.0, 255.0, "cutoff")
}

/// [`RasterMethod`] as an argument.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum RasterArg {
    /// As suits the class of device
    Auto,
    /// Quads through the device's blender, far to near; for phones
    #[value(alias = "hulls")]
    Quads,
    /// A compute kernel of which a workgroup shares what it reads, near to far until all pixels are
    /// saturated; for desktop GPUs
    TilesShared,
    /// One of which a subgroup of 4 or 8 shares what it reads; for CPU drivers
    TilesCooperative,
}

impl From<RasterArg> for Option<RasterMethod> {
    fn from(raster: RasterArg) -> Self {
        match raster {
            RasterArg::Auto => None,
            RasterArg::Quads => Some(RasterMethod::Quads),
            RasterArg::TilesShared => Some(RasterMethod::SharedTiles),
            RasterArg::TilesCooperative => Some(RasterMethod::CooperativeTiles),
        }
    }
}

/// [`SortVariant`] as an argument.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum SortArg {
    /// The fastest that passes a self-test on the device
    Auto,
    /// One pass over memory per digit, with subgroups and look-back; for GPUs
    Onesweep,
    /// Histograms of all tiles first, then their prefix sums; needs no subgroups and no look-back
    #[value(alias = "selfscan")]
    ReduceThenScan,
    /// Reduce-then-scan with a histogram per thread; for CPU drivers
    #[value(alias = "lanescan")]
    PerThread,
}

impl From<SortArg> for Option<SortVariant> {
    fn from(sort: SortArg) -> Self {
        match sort {
            SortArg::Auto => None,
            SortArg::Onesweep => Some(SortVariant::OneSweep),
            SortArg::ReduceThenScan => Some(SortVariant::ReduceThenScan),
            SortArg::PerThread => Some(SortVariant::PerThread),
        }
    }
}

/// Reads `WIDTHxHEIGHT`, pixels, or one number for both.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.trim().parse::<u32>().ok().filter(|&side| side > 0);
    let (width, height) = text.split_once(['x', 'X', '×']).unwrap_or((text, text));
    let sides = side(width).zip(side(height)).map(<[u32; 2]>::from);
    sides.ok_or_else(|| {
        format!(
            "`{text}` is not a size: write width x height in pixels, for instance 1280x720, or one \
             number for a square"
        )
    })
}

/// Reads a number from `min` to `max`; `what` names it in the error.
pub fn number(text: &str, min: f64, max: f64, what: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if (min..=max).contains(&value) => Ok(value),
        _ => Err(format!(
            "`{text}` is not a {what}: write a number from {min} to {max}"
        )),
    }
}

/// Reads how long to draw, minutes.
pub fn minutes(text: &str) -> Result<f64, String> {
    number(text, 0.01, 10_000.0, "number of minutes")
}

/// Reads a frame rate, frames per second.
pub fn rate(text: &str) -> Result<f64, String> {
    number(text, 0.5, 1000.0, "frame rate")
}

/// Reads a share of a whole.
pub fn share(text: &str) -> Result<f64, String> {
    number(text, 0.0, 1.0, "share")
}

/// Reads seconds into a clip.
pub fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds.is_finite() => Ok(seconds),
        _ => Err(format!("`{text}` is not a time: write a number of seconds")),
    }
}

/// Writes a trace, and prints where it is.
pub fn write_trace(path: &Path, trace: &TraceRecorder, gpu: &Gpu) -> anyhow::Result<()> {
    trace
        .write(path, gpu)
        .with_context(|| format!("{} can't be written", path.display()))?;
    eprintln!(
        "wrote {}: open it at https://ui.perfetto.dev",
        path.display()
    );
    Ok(())
}

/// Reads `RRGGBB`, with or without a leading #.
pub fn color(text: &str) -> Result<[f32; 3], String> {
    let hex = text.trim_start_matches('#');
    let value = u32::from_str_radix(hex, 16).ok().filter(|_| hex.len() == 6);
    let value = value.ok_or_else(|| {
        format!("`{text}` is not a colour: write six hexadecimal digits, for instance d8dde3")
    })?;
    Ok([16, 8, 0].map(|shift| (value >> shift & 0xff) as f32 / 255.0))
}

/// The default colour behind the avatar: a light grey.
pub const BACKGROUND: &str = "d8dde3";

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(Parser)]
    struct Only {
        #[command(flatten)]
        quality: QualityArgs,
    }

    fn options(arguments: &str) -> Result<String, clap::Error> {
        let only =
            Only::try_parse_from(["effigy"].into_iter().chain(arguments.split_whitespace()))?;
        Ok(format!("{:?}", only.quality.renderer([8, 8])))
    }

    #[test]
    fn a_size_is_two_numbers_or_one_of_a_square() {
        for (text, expected) in [
            ("512", [512, 512]),
            ("640x480", [640, 480]),
            ("3 × 4", [3, 4]),
        ] {
            assert_eq!(size(text), Ok(expected));
        }
        for wrong in ["", "0", "x", "512x", "-5", "1x2x3", "large"] {
            assert!(size(wrong).is_err_and(|error| error.contains(&format!("`{wrong}`"))));
        }
    }

    #[test]
    fn options_are_the_defaults_but_for_what_is_named() {
        let expect = |arguments, expected: RendererOptions| {
            assert_eq!(
                options(arguments).ok(),
                Some(format!("{expected:?}")),
                "{arguments}"
            );
        };
        expect("", RendererOptions::new([8, 8]));
        expect("--exact", RendererOptions::new([8, 8]).exactly());
        expect(
            "--exact --skip pose --draw-at-most 100000",
            RendererOptions {
                skip: Skip::POSE,
                gaussians: Some(100_000),
                ..RendererOptions::new([8, 8]).exactly()
            },
        );
        expect(
            "--cutoff 3 --skip pose --detail 1/4",
            RendererOptions {
                cutoff: 3.0 / 255.0,
                skip: Skip::POSE,
                detail: Detail::FULL.at_least(2),
                ..RendererOptions::new([8, 8])
            },
        );
        expect(
            "--filter 0.1+compensated",
            RendererOptions {
                filter: Some(Filter {
                    variance: 0.1,
                    compensated: true,
                }),
                ..RendererOptions::new([8, 8])
            },
        );
        expect("--filter own", RendererOptions::new([8, 8]));
        for wrong in [
            "--filter 0.05",
            "--filter compensated",
            "--filter nan",
            "--cutoff 0.5",
            "--cutoff 300",
            "--exact --cutoff 2",
            "--skip frames",
            "--detail 1/3",
        ] {
            assert!(options(wrong).is_err(), "{wrong} is accepted");
        }
    }
}
