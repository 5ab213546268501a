//! The progress of a training for people: views that it does not learn from, beside their pictures,
//! and a chart.

use crate::data::{ShotIndex, TrainingViews, shots, training_shots};
use crate::view::{Shows, TrainingView};
use effigy_capture::Capture;
use effigy_core::io::file::{FileError, replace};
use effigy_measure::chart::{
    Axis, BLUE, Chart, ChartError, Corner, Line, LineStyle, ORANGE, Panel,
};
use image::{ImageFormat, RgbImage};
use std::fs;
use std::io::{self, Cursor};
use std::path::Path;

/// Views that are watched, at most.
const WATCHED: usize = 4;
/// PSNR of watched views.
pub const LOG: &str = "watched.csv";
/// PSNR over the steps.
const CHART: &str = "training.svg";
/// How strong errors are shown.
const ERROR_SCALE: f32 = 4.0;

/// Views that are not learned from, or, where none is held out, some that are.
pub struct WatchedViews {
    /// The views.
    pub views: TrainingViews,
}

/// A view, and its image.
pub struct WatchedImage {
    /// The view.
    pub view: TrainingView,
    /// RGB of every pixel over the view's background.
    pub image: Vec<[f32; 3]>,
}

/// A few pictures that are held out, evenly spaced; without any, some of the training's. `size`:
/// of the views; smaller pictures are skipped.
pub fn watched_shots(capture: &Capture, size: [u32; 2]) -> Vec<ShotIndex> {
    let mut all = shots(capture, |camera, frame| camera || frame);
    if all.is_empty() {
        all = training_shots(capture);
    }
    all.retain(|shot| {
        let own = capture.cameras[shot.camera].camera.size;
        own[0] >= size[0] && own[1] >= size[1]
    });
    let count = WATCHED.min(all.len());
    (0..count)
        .map(|k| all[(2 * k + 1) * all.len() / (2 * count)])
        .collect()
}

impl WatchedImage {
    /// The mean squared error over what the picture is sure of, and over how many channels.
    fn squared_error(&self) -> (f64, usize) {
        let mut sum = 0.0;
        let mut channels = 0;
        for (pixel, own) in self.image.iter().enumerate() {
            if self.view.picture.shows(pixel) == Shows::Person {
                let [r, g, b, _] = self.view.picture.pixels[pixel];
                for (own, truth) in own.iter().zip([r, g, b]) {
                    sum += f64::from(own - f32::from(truth) / 255.0).powi(2);
                    channels += 1;
                }
            }
        }
        (sum, channels)
    }
}

impl WatchedViews {
    /// Watches some views.
    pub fn new(views: TrainingViews) -> Self {
        Self { views }
    }

    /// Adds a line to the log, and writes an image: of each view its picture, what is drawn, and
    /// the error, four times as strong.
    ///
    /// # Errors
    /// When a file can't be written.
    pub fn write(&self, folder: &Path, steps: u64, seen: &[WatchedImage]) -> Result<(), FileError> {
        let (sum, channels) = seen
            .iter()
            .map(WatchedImage::squared_error)
            .fold((0.0, 0), |(sum, count), (own, channels)| {
                (sum + own, count + channels)
            });
        let psnr = -10.0 * (sum / channels.max(1) as f64).max(1e-12).log10();
        let log = folder.join(LOG);
        let failed = |cause| FileError::Write {
            file: log.clone(),
            cause,
        };
        let known = match fs::read_to_string(&log) {
            Ok(known) => known,
            Err(error) if error.kind() == io::ErrorKind::NotFound => "step,psnr_db\n".into(),
            Err(cause) => return Err(failed(cause)),
        };
        replace(&log, format!("{known}{steps},{psnr:.3}\n").as_bytes())?;
        let file = folder.join(format!("watched-{steps:09}.png"));
        let mut bytes = Cursor::new(Vec::new());
        sheet(self.views.size(), seen)
            .write_to(&mut bytes, ImageFormat::Png)
            .map_err(|error| failed(io::Error::other(error)))?;
        replace(&file, bytes.get_ref())
    }
}

/// A row for each view: picture, image, error.
fn sheet(size: [u32; 2], seen: &[WatchedImage]) -> RgbImage {
    let [width, height] = size;
    let mut sheet = RgbImage::new(3 * width, height * seen.len() as u32);
    for (row, one) in (0..).zip(seen) {
        for (pixel, own) in one.image.iter().enumerate() {
            let x = pixel as u32 % width;
            let y = pixel as u32 / width + row * height;
            let [r, g, b, _] = one.view.picture.pixels[pixel];
            let truth = [r, g, b];
            let byte = |v: f32| (255.0 * v.clamp(0.0, 1.0)).round() as u8;
            let error: [u8; 3] = std::array::from_fn(|c| {
                byte(ERROR_SCALE * (own[c] - f32::from(truth[c]) / 255.0).abs())
            });
            sheet.put_pixel(x, y, image::Rgb(truth));
            sheet.put_pixel(x + width, y, image::Rgb(own.map(byte)));
            sheet.put_pixel(x + 2 * width, y, image::Rgb(error));
        }
    }
    sheet
}

/// Draws both logs of a training's folder as a chart.
///
/// # Errors
/// When a log can't be read or the chart not be written.
pub fn chart(folder: &Path) -> Result<(), FileError> {
    let points = |name: &str, column: &str| -> Result<Vec<(f64, f64)>, FileError> {
        let file = folder.join(name);
        let text = fs::read_to_string(&file).map_err(|cause| FileError::Read {
            file: file.clone(),
            cause,
        })?;
        let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let head = lines.next().unwrap_or_default();
        let at = head.iter().position(|name| *name == column).unwrap_or(0);
        let number = |line: &Vec<&str>, at: usize| line.get(at)?.parse::<f64>().ok();
        Ok(lines
            .filter_map(|line| Some((number(&line, 0)?, number(&line, at)?)))
            .collect())
    };
    let learned = points("log.csv", "psnr_db")?;
    let watched = points(LOG, "psnr_db")?;
    let file = folder.join(CHART);
    match drawn(learned, watched) {
        Ok(svg) => replace(&file, &svg),
        Err(error) => Err(FileError::Write {
            file,
            cause: io::Error::other(error),
        }),
    }
}

/// The SVG of both logs.
fn drawn(learned: Vec<(f64, f64)>, watched: Vec<(f64, f64)>) -> Result<Vec<u8>, ChartError> {
    let points = || learned.iter().chain(&watched).copied();
    let x = Axis::around("steps", points().map(|point| point.0), 0.0, 0.0)?;
    let y = Axis::around("dB", points().map(|point| point.1), 0.06, 0.0)?;
    let mut panel = Panel::new(x, y);
    let whole = "pictures it learns from, whole views";
    let person = "watched pictures, the person alone";
    panel.lines = vec![
        Line::new(whole, BLUE, LineStyle::Dotted, learned),
        Line::new(person, ORANGE, LineStyle::Dotted, watched),
    ];
    panel.legend = Some(Corner::UpperRight);
    let chart = Chart {
        title: "PSNR while it learns".into(),
        size: [1000, 640],
        panels: vec![panel],
    };
    chart.encoded("svg")
}
