//! Arguments that several commands share, and how they are written.

use crate::{
    frame::{Camera, Detail, Skip},
    measure::trace::Trace,
    vulkan::{
        Gpu, GpuOptions, RendererOptions,
        preset::Preset,
        raster::{ColorFormat, Method},
        sort::{KeyBits, Variant},
    },
};
use anyhow::Context;
use clap::ValueEnum;
use glam::DVec3;
use std::path::{Path, PathBuf};

/// Where the camera stands.
#[derive(clap::Args, Clone, Debug)]
pub struct View {
    /// Degrees around the avatar: 0 sees its front, 90 its left side
    #[arg(long, default_value_t = 20.0, allow_negative_numbers = true)]
    pub yaw: f64,
    /// Degrees above the horizon
    #[arg(long, default_value_t = 5.0, allow_negative_numbers = true)]
    pub pitch: f64,
    /// Metres from the avatar's middle [default: all of it in the picture]
    #[arg(long)]
    pub distance: Option<f64>,
    /// Height that the camera looks at, metres above the avatar's middle
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true)]
    pub raise: f64,
    /// Vertical field of view, degrees
    #[arg(long, default_value_t = 35.0)]
    pub fov: f64,
}

impl View {
    /// The camera around a box that the avatar fills.
    pub fn camera(&self, bounds: [DVec3; 2], size: [u32; 2]) -> anyhow::Result<Camera> {
        anyhow::ensure!((1.0..=170.0).contains(&self.fov), "a field of view of {}° can't be drawn: give --fov from 1 to 170", self.fov);
        let fov = self.fov.to_radians();
        let distance = self.distance.unwrap_or_else(|| Camera::framing_distance(bounds, fov, size));
        let target = (bounds[0] + bounds[1]) / 2.0 + self.raise * DVec3::Y;
        let (yaw, pitch) = (self.yaw.to_radians(), self.pitch.clamp(-89.0, 89.0).to_radians());
        let camera = Camera::orbit(target, yaw, pitch, distance, fov, size);
        camera.check().context("there is no such view: give --yaw, --pitch, --distance and --raise as plain numbers")?;
        Ok(camera)
    }
}

/// What draws, and how exactly.
#[derive(clap::Args, Clone, Debug)]
pub struct Quality {
    /// GPU to use: part of its name, or its number in `effigy devices` [default: the first that can serve]
    #[arg(long, value_name = "NAME")]
    pub device: Option<String>,
    /// How much error to trade for time: low, balanced, high or exact; the options below override what it says
    #[arg(long, value_name = "NAME", default_value_t)]
    pub preset: Preset,
    /// What pictures are blended in
    #[arg(long, value_enum)]
    pub color: Option<Color>,
    /// Use no more of the device than the least one has that can run this
    #[arg(long)]
    pub least: bool,
    /// How to draw
    #[arg(long, value_enum, default_value_t = DrawBy::Auto)]
    pub raster: DrawBy,
    /// Bits of the depth key that Gaussians are sorted by
    #[arg(long, value_enum)]
    pub keys: Option<Keys>,
    /// How to sort
    #[arg(long, value_enum, default_value_t = SortBy::Auto)]
    pub sort: SortBy,
    /// What to leave out where the scene doesn't need it: all, none, or names with commas between
    #[arg(long)]
    pub skip: Option<Skip>,
    /// Opacity under which nothing is drawn, in 255ths, 1 or more
    #[arg(long, value_name = "N", value_parser = cutoff)]
    pub cutoff: Option<f64>,
    /// Millimetres behind the avatar's front from which on nothing is drawn
    #[arg(long, value_name = "MM", value_parser = length)]
    pub margin: Option<f64>,
    /// How many of an avatar's Gaussians to draw: full, 1/2, 1/4, 1/8, or auto: fewer of small ones
    #[arg(long, value_name = "SHARE")]
    pub detail: Option<Detail>,
}

impl Quality {
    pub fn gpu(&self) -> GpuOptions {
        GpuOptions { least: self.least, ..GpuOptions::headless(self.device.clone()) }
    }

    pub fn renderer(&self, size: [u32; 2]) -> RendererOptions {
        let preset = self.preset.apply(RendererOptions::new(size));
        RendererOptions {
            color: self.color.map(Into::into).or(preset.color),
            key_bits: self.keys.map_or(preset.key_bits, Into::into),
            method: self.raster.into(),
            sort: self.sort.into(),
            skip: self.skip.unwrap_or(preset.skip),
            cutoff: self.cutoff.map_or(preset.cutoff, |n| n / 255.0),
            margin: self.margin.map_or(preset.margin, |mm| mm / 1e3),
            detail: self.detail.unwrap_or(preset.detail),
            ..preset
        }
    }
}

fn cutoff(text: &str) -> Result<f64, String> {
    let value = text.parse().ok().filter(|n| (1.0..=255.0).contains(n));
    value.ok_or_else(|| format!("`{text}` is no cutoff: write a number from 1, where nothing that shows is left out, to 255"))
}

fn length(text: &str) -> Result<f64, String> {
    let value = text.parse().ok().filter(|value: &f64| value.is_finite() && *value >= 0.0);
    value.ok_or_else(|| format!("`{text}` is no length: write a number of 0 or more"))
}

/// [`ColorFormat`] as the command line has it.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Color {
    /// 4 bytes a pixel, rounded after every Gaussian
    Rgba8,
    /// 8 bytes a pixel
    Rgba16f,
}

impl From<Color> for ColorFormat {
    fn from(color: Color) -> Self {
        match color {
            Color::Rgba8 => Self::Rgba8,
            Color::Rgba16f => Self::Rgba16F,
        }
    }
}

/// [`Method`] as the command line has it.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum DrawBy {
    /// What is known to be faster on the device's kind
    Auto,
    /// Quads through the device's blender, far to near
    Hulls,
    /// A compute kernel, near to far until a pixel is full
    Tiles,
}

impl From<DrawBy> for Option<Method> {
    fn from(raster: DrawBy) -> Self {
        match raster {
            DrawBy::Auto => None,
            DrawBy::Hulls => Some(Method::Hulls),
            DrawBy::Tiles => Some(Method::Tiles),
        }
    }
}

/// [`KeyBits`] as the command line has it.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Keys {
    /// Two passes; steps of about 30 µm
    #[value(name = "16")]
    Bits16,
    /// Three passes; steps of less than a micrometre
    #[value(name = "24")]
    Bits24,
    /// Four passes
    #[value(name = "32")]
    Bits32,
}

impl From<Keys> for KeyBits {
    fn from(keys: Keys) -> Self {
        match keys {
            Keys::Bits16 => Self::Sixteen,
            Keys::Bits24 => Self::TwentyFour,
            Keys::Bits32 => Self::ThirtyTwo,
        }
    }
}

/// [`Variant`] as the command line has it.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum SortBy {
    /// The fastest that a test finds right on the device
    Auto,
    /// Look-back over subgroups, for GPUs
    Onesweep,
    /// No subgroups, no look-back
    Selfscan,
    /// The same with counters for each invocation, for CPUs
    Lanescan,
}

impl From<SortBy> for Option<Variant> {
    fn from(sort: SortBy) -> Self {
        match sort {
            SortBy::Auto => None,
            SortBy::Onesweep => Some(Variant::OneSweep),
            SortBy::Selfscan => Some(Variant::SelfScan),
            SortBy::Lanescan => Some(Variant::LaneScan),
        }
    }
}

/// Reads `WIDTHxHEIGHT`.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let parse = |side: &str| side.trim().parse::<u32>().ok().filter(|&side| side > 0);
    let sides = text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some([parse(width)?, parse(height)?]));
    sides.ok_or_else(|| format!("`{text}` is no picture size: write width x height in pixels, for instance 1024x1024"))
}

/// Reads a number of a range.
pub fn number(text: &str, low: f64, high: f64, what: &str) -> Result<f64, String> {
    let value = text.parse().ok().filter(|value| (low..=high).contains(value));
    value.ok_or_else(|| format!("`{text}` is no {what}: write a number from {low} to {high}"))
}

/// Reads how long to go on.
pub fn minutes(text: &str) -> Result<f64, String> {
    number(text, 0.01, 10_000.0, "number of minutes")
}

/// Reads frames a second.
pub fn rate(text: &str) -> Result<f64, String> {
    number(text, 0.5, 1000.0, "frame rate")
}

/// Reads the name of a trace's file. It must end in `.json`, lest an avatar be written over.
pub fn trace(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let fits = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    fits.then_some(path).ok_or_else(|| format!("`{text}` does not end in .json"))
}

/// Writes a trace, and says so.
pub fn write_trace(path: &Path, trace: &Trace, gpu: &Gpu) -> anyhow::Result<()> {
    trace.write(path, gpu).with_context(|| format!("{} can't be written", path.display()))?;
    eprintln!("wrote {}: open it at https://ui.perfetto.dev", path.display());
    Ok(())
}

/// Reads `RRGGBB`, with or without a leading #.
pub fn color(text: &str) -> Result<[f32; 3], String> {
    let hex = text.trim_start_matches('#');
    let value = u32::from_str_radix(hex, 16).ok().filter(|_| hex.len() == 6);
    let value = value.ok_or_else(|| format!("`{text}` is no colour: write six hexadecimal digits, for instance d8dde3"))?;
    Ok([16, 8, 0].map(|shift| (value >> shift & 0xff) as f32 / 255.0))
}

/// What is behind the avatar unless told otherwise: a light grey.
pub const BACKGROUND: &str = "d8dde3";

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(Parser)]
    struct Only {
        #[command(flatten)]
        quality: Quality,
    }

    fn options(arguments: &str) -> Result<String, clap::Error> {
        let only = Only::try_parse_from(["effigy"].into_iter().chain(arguments.split_whitespace()))?;
        Ok(format!("{:?}", only.quality.renderer([8, 8])))
    }

    #[test]
    fn an_option_overrides_its_part_of_the_preset() {
        let of = |preset: Preset| preset.apply(RendererOptions::new([8, 8]));
        let expect = |arguments, expected: RendererOptions| {
            assert_eq!(options(arguments).ok(), Some(format!("{expected:?}")), "{arguments}");
        };
        expect("", RendererOptions::new([8, 8]));
        expect("--preset low", of(Preset::Low));
        expect(
            "--preset low --keys 32 --color rgba16f",
            RendererOptions { key_bits: KeyBits::ThirtyTwo, color: Some(ColorFormat::Rgba16F), ..of(Preset::Low) },
        );
        expect(
            "--cutoff 3 --margin 7 --preset exact --skip pose --detail 1/4",
            RendererOptions { cutoff: 3.0 / 255.0, margin: 0.007, skip: Skip::POSE, detail: Detail::FULL.at_least(2), ..of(Preset::Exact) },
        );
        for wrong in ["--cutoff 0.5", "--cutoff 300", "--margin -1", "--margin inf", "--preset lowest", "--skip frames", "--detail 1/3"] {
            assert!(options(wrong).is_err(), "{wrong} is accepted");
        }
    }
}
