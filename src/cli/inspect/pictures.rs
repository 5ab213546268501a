//! What a capture of pictures has that a training would learn from.

use super::text::{line, thousands};
use effigy_capture::{Capture, CaptureOpenOptions, tally};
use effigy_train::data::training_shots;
use serde::Serialize;
use std::{collections::BTreeMap, fmt, path::Path};

/// Faults that are written out, of those that leave something out; the others are counted.
const NAMED: usize = 8;

/// A capture's counts, and what of it can't be used.
#[derive(Serialize)]
pub struct PicturesSummary {
    kind: &'static str,
    layout: &'static str,
    cameras: usize,
    held_cameras: Vec<String>,
    /// Widths and heights of pictures, px, with the number of cameras that have them.
    sizes: Vec<Size>,
    frames: usize,
    held_frames: usize,
    pictures: usize,
    /// Those of cameras and frames that are not held out.
    learned: usize,
    joints: usize,
    vertices: usize,
    /// Numbers of the expression.
    expression: usize,
    /// How often something is left out for each reason.
    left_out: BTreeMap<&'static str, usize>,
    faults: Vec<String>,
    masks: Masks,
    /// What the files leave open, and what is taken.
    assumptions: Vec<String>,
}

/// What a look at some masks found.
#[derive(Serialize)]
struct Masks {
    looked_at: usize,
    faults: Vec<String>,
    #[serde(skip)]
    text: String,
}

#[derive(Serialize)]
struct Size {
    width: u32,
    height: u32,
    cameras: usize,
}

impl PicturesSummary {
    /// None: the folder is no capture. `template`: its body model, if that lies elsewhere.
    pub fn new(folder: &Path, template: Option<&Path>) -> anyhow::Result<Option<Self>> {
        let Some(layout) = Capture::layout(folder) else {
            return Ok(None);
        };
        let options = CaptureOpenOptions {
            template: template.map(Path::to_owned),
        };
        let capture = Capture::read_with(folder, &options)?;
        let mut sizes: BTreeMap<[u32; 2], usize> = BTreeMap::new();
        for own in &capture.cameras {
            *sizes.entry(own.camera.size).or_default() += 1;
        }
        let held = capture.cameras.iter().filter(|own| own.held);
        Ok(Some(Self {
            kind: "capture of pictures",
            layout,
            cameras: capture.cameras.len(),
            held_cameras: held.map(|own| own.name.clone()).collect(),
            sizes: sizes
                .into_iter()
                .map(|([width, height], cameras)| Size {
                    width,
                    height,
                    cameras,
                })
                .collect(),
            frames: capture.frames.len(),
            held_frames: capture.frames.iter().filter(|frame| frame.held).count(),
            pictures: capture.pictures(),
            learned: training_shots(&capture).len(),
            joints: capture.template.skeleton.len(),
            vertices: capture.template.vertices.len(),
            expression: capture.template.expression,
            left_out: tally(&capture.left_out),
            faults: capture
                .left_out
                .iter()
                .take(NAMED)
                .map(|fault| fault.to_string())
                .collect(),
            masks: Masks {
                looked_at: capture.masks.count,
                faults: capture
                    .masks
                    .faults
                    .iter()
                    .map(ToString::to_string)
                    .collect(),
                text: capture.masks.to_string(),
            },
            assumptions: capture
                .assumptions
                .iter()
                .map(ToString::to_string)
                .collect(),
        }))
    }
}

impl fmt::Display for PicturesSummary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        line(
            f,
            "capture",
            format_args!(
                "of pictures, laid out as {}; `effigy train` learns an avatar from it",
                self.layout
            ),
        )?;
        let held = match &self.held_cameras[..] {
            [] => "none held out".into(),
            names => format!("held out: {}", names.join(", ")),
        };
        line(f, "cameras", format_args!("{}; {held}", self.cameras))?;
        for Size {
            width,
            height,
            cameras,
        } in &self.sizes
        {
            let text = format_args!("{width} × {height} px, of {cameras} cameras");
            line(f, "size", text)?;
        }
        line(
            f,
            "frames",
            format_args!(
                "{}, {} of them held out",
                thousands(self.frames),
                thousands(self.held_frames)
            ),
        )?;
        line(
            f,
            "pictures",
            format_args!(
                "{}, {} of them to learn from",
                thousands(self.pictures),
                thousands(self.learned)
            ),
        )?;
        line(
            f,
            "body model",
            format_args!(
                "{} joints, {} vertices, {} numbers of expression",
                self.joints,
                thousands(self.vertices),
                self.expression
            ),
        )?;
        line(f, "masks", &self.masks.text)?;
        for assumption in &self.assumptions {
            line(f, "taken", assumption)?;
        }
        for (reason, count) in &self.left_out {
            line(f, "left out", format_args!("{count} × {reason}"))?;
        }
        for fault in &self.faults {
            line(f, "", fault)?;
        }
        let unnamed = self.left_out.values().sum::<usize>() - self.faults.len();
        if unnamed > 0 {
            line(f, "", format_args!("and {} more", thousands(unnamed)))?;
        }
        Ok(())
    }
}
