//! The parts that all reports share: program, device, avatar, options and errors; reading a report
//! back; and how the setups of two reports differ. The fields are the keys of the JSON.
//!
//! JSON has no infinity: a PSNR that is null in an [`ErrorReport`] means no error at all.

use crate::{error::ErrorMetrics, setting::RenderSetting};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    frame::{RendererOptions, Skip},
    scene::Detail,
};
use effigy_render::vulkan::Gpu;
use serde::{Deserialize, Deserializer, Serialize, de::DeserializeOwned};
use std::time::SystemTime;

/// The program that measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Program {
    /// Version of the package.
    pub version: String,
    /// The commit that the program was built from, with a `+` if its files differed. Null if the
    /// build did not know.
    pub commit: Option<String>,
    /// UTC, RFC 3339.
    pub date: String,
    /// The command line.
    pub command: Vec<String>,
}

impl Program {
    /// This program, now, started with a command line.
    pub fn current(command: Vec<String>) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            commit: crate::commit().map(str::to_owned),
            date: humantime::format_rfc3339_seconds(SystemTime::now()).to_string(),
            command,
        }
    }
}

/// The device that was measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DeviceReport {
    /// Name of the device.
    pub name: String,
    /// Name and version.
    pub driver: String,
    /// Vulkan version, as in 1.3.0. Empty behind WebGPU.
    pub vulkan: String,
    /// Invocations of a subgroup; 0 if unknown.
    pub subgroup_size: u32,
    /// Whether the device has timestamps; without them there are no GPU times.
    pub timestamps: bool,
    /// `vulkan` or `webgpu`. Empty in reports from before there was a choice.
    #[serde(default)]
    pub backend: String,
}

impl DeviceReport {
    /// A device behind Vulkan.
    pub fn from_vulkan(gpu: &Gpu) -> Self {
        let version = gpu.probe.api_version;
        let major = version >> 22 & 0x7f;
        let minor = version >> 12 & 0x3ff;
        let patch = version & 0xfff;
        Self {
            name: gpu.probe.name.clone(),
            driver: gpu.probe.driver.clone(),
            vulkan: format!("{major}.{minor}.{patch}"),
            subgroup_size: gpu.probe.subgroup_size,
            timestamps: gpu.probe.timestamp_bits > 0,
            backend: "vulkan".into(),
        }
    }
}

/// The avatar that was drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Subject {
    /// Name of the avatar.
    pub name: String,
    /// Name of the clip.
    pub clip: String,
    /// Number of Gaussians.
    pub gaussians: u64,
    /// Number of parts.
    pub parts: u64,
    /// Number of position nodes.
    pub nodes: u64,
    /// Basis rows: rotation, scale, colour.
    pub rows: [u64; 3],
}

impl Subject {
    /// An avatar and the clip that moves it.
    pub fn new(avatar: &Avatar, player: &Player) -> Self {
        let rows = [
            avatar.rotation_rows.gaussian.len(),
            avatar.scale_rows.gaussian.len(),
            avatar.color_rows.gaussian.len(),
        ];
        Self {
            name: avatar.name.clone(),
            clip: player.clip().name.clone(),
            gaussians: avatar.gaussians.len() as u64,
            parts: avatar.parts.len() as u64,
            nodes: avatar.nodes.len() as u64,
            rows: rows.map(|count| count as u64),
        }
    }
}

/// The options that it was drawn with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OptionsReport {
    /// Format of the image: `rgba8` or `rgba16f`.
    pub color: String,
    /// `quads` or `tiles`. Empty in reports from before there was a choice.
    #[serde(default)]
    pub raster: String,
    /// Work that may be skipped, as `--skip` names it.
    #[serde(deserialize_with = "skip_names")]
    pub skip: String,
    /// Opacity under which nothing is drawn, 0 to 1.
    pub cutoff: f64,
    /// How many of an avatar's Gaussians are drawn: all in reports from before there was a choice.
    #[serde(default = "full_detail")]
    pub detail: String,
    /// The low-pass as `--filter` spells it: the avatar's own in reports from before there was a
    /// choice.
    #[serde(default = "own_filter")]
    pub filter: String,
    /// Share of the basis rows that is retained, 0 to 1.
    pub rows: f64,
    /// Frames that each pose is held for.
    pub hold: usize,
}

/// A list of `--skip`, also one with old names.
fn skip_names<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    let names = String::deserialize(deserializer)?;
    Ok(present_skip_names(&names))
}

/// A list of `--skip` with the names that it has today. What has no name any more stays as it is.
pub fn present_skip_names(names: &str) -> String {
    let present = |name: &str| {
        name.parse()
            .map_or(name.into(), |skip: Skip| skip.to_string())
    };
    let names: Vec<String> = names.split(',').map(present).collect();
    names.join(",")
}

fn full_detail() -> String {
    Detail::FULL.to_string()
}

fn own_filter() -> String {
    "own".into()
}

impl OptionsReport {
    /// The options of a setting.
    pub fn new(setting: &RenderSetting) -> Self {
        let options = &setting.options;
        Self {
            color: options.color().name().to_owned(),
            raster: raster_name(options),
            skip: options.skip.to_string(),
            cutoff: options.cutoff,
            detail: options.detail.to_string(),
            filter: options
                .filter
                .map_or_else(own_filter, |filter| filter.to_string()),
            rows: setting.rows,
            hold: setting.hold,
        }
    }
}

/// The rasterizer of resolved options, as `--raster` spells it.
fn raster_name(options: &RendererOptions) -> String {
    options
        .method
        .map_or_else(String::new, |method| method.name().to_owned())
}

/// The worst error of the frames that were compared with the reference, each number by itself.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorReport {
    /// Frames compared.
    pub frames: usize,
    /// Over covered pixels, dB; null if there is no error at all.
    pub psnr_db: Option<f64>,
    /// Largest error of a channel over covered pixels, 0 to 1.
    pub max_error: f64,
    /// Share of the covered pixels with every channel within 4/255.
    pub within_tolerance: f64,
    /// Over whole images, empty background included, dB.
    pub psnr_db_whole: Option<f64>,
    /// Largest error of a channel over whole images, 0 to 1.
    pub max_error_whole: f64,
    /// Mean FLIP over covered pixels, if it was asked for.
    pub flip: Option<f64>,
}

impl ErrorReport {
    /// No frame was compared.
    pub const NONE: Self = Self {
        frames: 0,
        psnr_db: None,
        max_error: 0.0,
        within_tolerance: 1.0,
        psnr_db_whole: None,
        max_error_whole: 0.0,
        flip: None,
    };

    /// The error of one frame.
    pub fn new(error: &ErrorMetrics, flip: Option<f64>) -> Self {
        let finite = |db: f64| db.is_finite().then_some(db);
        Self {
            frames: 1,
            psnr_db: finite(error.covered.psnr_db),
            max_error: error.covered.max_error,
            within_tolerance: error.covered.within_tolerance,
            psnr_db_whole: finite(error.whole.psnr_db),
            max_error_whole: error.whole.max_error,
            flip,
        }
    }

    /// The worse of each number. A PSNR that is missing is the best there is.
    pub fn worse(self, other: Self) -> Self {
        let lower = |a: Option<f64>, b: Option<f64>| a.into_iter().chain(b).reduce(f64::min);
        Self {
            frames: self.frames + other.frames,
            psnr_db: lower(self.psnr_db, other.psnr_db),
            max_error: self.max_error.max(other.max_error),
            within_tolerance: self.within_tolerance.min(other.within_tolerance),
            psnr_db_whole: lower(self.psnr_db_whole, other.psnr_db_whole),
            max_error_whole: self.max_error_whole.max(other.max_error_whole),
            flip: self.flip.into_iter().chain(other.flip).reduce(f64::max),
        }
    }
}

/// Why a text can't be read as a report.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// It is not JSON.
    #[error("it is not JSON: {0}")]
    NotJson(serde_json::Error),
    /// Its schema is another.
    #[error(
        "its schema is {found}, this program reads `{expected}`: measure again with this version of the program"
    )]
    Schema {
        /// The schema found, in words.
        found: String,
        /// The schema that this program reads.
        expected: &'static str,
    },
    /// A key is missing or has another type.
    #[error("it is not a complete report: {0}")]
    Incomplete(serde_json::Error),
}

/// Reads a report from JSON whose key `schema` must be `schema`.
///
/// # Errors
/// When the text is something else.
pub fn read_report<T: DeserializeOwned>(text: &str, schema: &'static str) -> Result<T, ReadError> {
    let value: serde_json::Value = serde_json::from_str(text).map_err(ReadError::NotJson)?;
    let found = value.get("schema").and_then(|schema| schema.as_str());
    if found == Some(schema) {
        return serde_json::from_value(value).map_err(ReadError::Incomplete);
    }
    Err(ReadError::Schema {
        found: found.map_or("not given".to_owned(), |found| format!("`{found}`")),
        expected: schema,
    })
}

/// The parts of a report that must be equal for its numbers to be comparable.
pub struct Setup<'a> {
    /// The device that was measured.
    pub device: &'a DeviceReport,
    /// The avatar that was drawn.
    pub avatar: &'a Subject,
    /// Width and height of the image, px.
    pub size: [u32; 2],
    /// The options that it was drawn with.
    pub options: &'a OptionsReport,
}

impl Setup<'_> {
    /// A sentence for each fact that differs from another setup.
    pub fn differences(&self, other: &Setup) -> Vec<String> {
        let facts = self.facts().into_iter().zip(other.facts());
        facts
            .filter_map(|((name, a), (_, b))| difference(name, a, b))
            .collect()
    }

    fn facts(&self) -> [(&'static str, String); 7] {
        let avatar = &self.avatar;
        let subject = format!(
            "{}, {} Gaussians, {:?} rows",
            avatar.name, avatar.gaussians, avatar.rows
        );
        let options = serde_json::to_string(&self.options).unwrap_or_default();
        [
            ("device", self.device.name.clone()),
            ("driver", self.device.driver.clone()),
            ("backend", self.device.backend.clone()),
            ("avatar", subject),
            ("clip", avatar.clip.clone()),
            ("image size", format!("{} × {}", self.size[0], self.size[1])),
            ("options", options),
        ]
    }
}

/// A sentence if two values of a fact differ.
pub fn difference(name: &str, a: String, b: String) -> Option<String> {
    (a != b).then(|| format!("the {name} differs: {a} against {b}"))
}

/// The title of a chart: what was measured, at which size (px), and on what.
pub fn chart_title(avatar: &Subject, size: [u32; 2], device: &DeviceReport) -> String {
    format!(
        "{}, {} Gaussians, {} × {}, on {}",
        avatar.name, avatar.gaussians, size[0], size[1], device.name
    )
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A body that was measured.
    pub(crate) const MEASURED: &str = include_str!("../../docs/benchmarks/2026-11-27-nodes.json");

    /// A part of its report.
    pub(crate) fn part<T: DeserializeOwned>(key: &str) -> T {
        let mut report: serde_json::Value = serde_json::from_str(MEASURED).expect("a report");
        serde_json::from_value(report[key].take()).expect("a part of it")
    }

    #[test]
    fn the_worst_frame_counts_and_a_perfect_one_does_not() {
        let perfect = ErrorReport {
            frames: 1,
            flip: Some(0.0),
            ..ErrorReport::NONE
        };
        let bad = ErrorReport {
            psnr_db: Some(40.0),
            max_error: 0.5,
            within_tolerance: 0.9,
            flip: Some(0.1),
            ..perfect
        };
        let good = ErrorReport {
            psnr_db: Some(60.0),
            max_error: 0.1,
            within_tolerance: 0.99,
            flip: Some(0.2),
            ..perfect
        };
        assert_eq!(perfect.worse(bad), ErrorReport { frames: 2, ..bad });
        let worst = ErrorReport {
            frames: 3,
            flip: Some(0.2),
            ..bad
        };
        assert_eq!(good.worse(perfect).worse(bad), worst);
    }

    #[test]
    fn options_of_old_reports_get_their_present_names() {
        let mut old: serde_json::Value = part("options");
        old["skip"] = "faint,hidden,full,area".into();
        old["margin"] = 0.005.into();
        let read: OptionsReport = serde_json::from_value(old).expect("options");
        // Gaussians behind the body's inside are not left out any more.
        assert_eq!(read.skip, "faint,hidden,saturated,damage");
    }

    #[test]
    fn other_schemas_are_rejected_by_name() {
        let message = |text: &str| {
            read_report::<Program>(text, "effigy-test-2")
                .expect_err("it is not a report")
                .to_string()
        };
        assert!(message("{").contains("not JSON"));
        assert!(message(r#"{"device": "A"}"#).contains("not given"));
        let old = message(r#"{"schema": "effigy-test-1"}"#);
        for part in ["effigy-test-1", "effigy-test-2", "measure again"] {
            assert!(old.contains(part), "{old}");
        }
        assert!(message(r#"{"schema": "effigy-test-2"}"#).contains("missing field"));
    }
}
