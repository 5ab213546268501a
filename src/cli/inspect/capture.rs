//! Motion capture, in numbers, and how well an avatar follows it.

use super::text::{line, thousands};
use effigy_formats::{
    capture::Capture,
    retarget::{Basis, Report, Spread},
};
use serde::Serialize;
use std::{collections::BTreeMap, fmt};

/// A capture's counts, and what was found in it.
#[derive(Serialize)]
pub struct CaptureSummary {
    kind: &'static str,
    frames: usize,
    /// Frames a second.
    rate: f64,
    /// Seconds.
    duration: f64,
    joints: usize,
    /// The axis that points up.
    up: String,
    unit: &'static str,
    /// What aligns the bodies.
    aligned_by: &'static str,
    /// Parts of a body and the joints that were taken for them.
    parts: BTreeMap<String, String>,
    /// `parts` in the order of the body, a line each.
    #[serde(skip)]
    in_order: Vec<String>,
    moves: ComparisonSummary,
}

/// How well an avatar follows a capture.
#[derive(Serialize)]
pub struct ComparisonSummary {
    /// Joints of the avatar that move.
    moved: usize,
    /// Joints of the avatar.
    of: usize,
    /// Size of the avatar's legs beside those of the capture.
    scale: f64,
    hips_mm: Range,
    joints_mm: Range,
    bones_degrees: Range,
    contacts: usize,
    standing: f64,
    slide_mm_per_second: Range,
    capture_slide_mm_per_second: Range,
    sink_mm: Range,
    /// How much deeper than the capture's the avatar's arms are inside its trunk.
    arms_inside_mm: Option<Range>,
    /// `arms_inside_mm` before shoulders were turned.
    arms_inside_before_mm: Option<Range>,
}

#[derive(Serialize)]
struct Range {
    mean: f64,
    max: f64,
}

impl Range {
    fn new(spread: Spread, unit: f64) -> Self {
        Self {
            mean: spread.mean / unit,
            max: spread.max / unit,
        }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "mean {:.1}, at most {:.1}", self.mean, self.max)
    }
}

impl CaptureSummary {
    pub fn new(capture: &Capture, report: &Report) -> Self {
        let up = report.up.to_array();
        let axis = up.iter().position(|part| part.abs() > 0.5).unwrap_or(1);
        let sign = if up[axis] < 0.0 { "-" } else { "" };
        let taken = report.joints.iter();
        Self {
            kind: "capture",
            frames: capture.frames(),
            rate: capture.rate,
            duration: capture.duration(),
            joints: capture.joints.len(),
            up: format!("{sign}{}", ["x", "y", "z"][axis]),
            unit: report.unit.name,
            aligned_by: match report.basis {
                Basis::Rest => "its rest pose",
                Basis::Motion => "its bones and motion, since its rest pose does not stand",
            },
            parts: taken
                .clone()
                .map(|guess| (guess.part.clone(), guess.joint.clone()))
                .collect(),
            in_order: taken
                .map(|guess| format!("{:<18} {}", guess.part, guess.joint))
                .collect(),
            moves: ComparisonSummary::new(report),
        }
    }
}

impl ComparisonSummary {
    pub fn new(report: &Report) -> Self {
        let millimetres = |spread: Spread| Range::new(spread, 1e-3);
        Self {
            moved: report.driven,
            of: report.all,
            scale: report.scale,
            hips_mm: millimetres(report.hips),
            joints_mm: millimetres(report.positions),
            bones_degrees: Range::new(report.directions, 1.0),
            contacts: report.contacts,
            standing: report.standing,
            slide_mm_per_second: millimetres(report.slide),
            capture_slide_mm_per_second: millimetres(report.source_slide),
            sink_mm: millimetres(report.sink),
            arms_inside_mm: report.arms.map(|arms| millimetres(arms.after)),
            arms_inside_before_mm: report.arms.map(|arms| millimetres(arms.before)),
        }
    }
}

impl fmt::Display for ComparisonSummary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let moved = format!(
            "{} of {} joints move; its legs are {:.2} times as long as the capture's",
            self.moved, self.of, self.scale
        );
        line(f, "avatar", moved)?;
        line(
            f,
            "bones",
            format_args!("{} degrees off", self.bones_degrees),
        )?;
        line(f, "joints", format_args!("{} mm off", self.joints_mm))?;
        line(f, "hips", format_args!("{} mm off in height", self.hips_mm))?;
        let standing = format!(
            "{} contacts, {:.0} % of the time of both feet",
            self.contacts,
            100.0 * self.standing
        );
        line(f, "feet", standing)?;
        let slide = format!(
            "{} mm a second in contacts; the capture's {}",
            self.slide_mm_per_second, self.capture_slide_mm_per_second
        );
        line(f, "slide", slide)?;
        line(f, "sink", format_args!("{} mm", self.sink_mm))?;
        if let (Some(after), Some(before)) = (&self.arms_inside_mm, &self.arms_inside_before_mm) {
            let inside = format!(
                "{after} mm deeper in the trunk than the capture's; before turning the shoulders: {before}"
            );
            line(f, "arms", inside)?;
        }
        Ok(())
    }
}

impl fmt::Display for CaptureSummary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        line(f, "capture", format_args!("{} joints", self.joints))?;
        let frames = format!(
            "{} at {:.4} per second, {:.3} s",
            thousands(self.frames),
            self.rate,
            self.duration
        );
        line(f, "frames", frames)?;
        line(
            f,
            "axes",
            format_args!("{} points up; {}", self.up, self.unit),
        )?;
        line(f, "aligned by", self.aligned_by)?;
        write!(f, "{}", self.moves)?;
        line(f, "parts", "taken for joints; --joints says otherwise:")?;
        for part in &self.in_order {
            writeln!(f, "{:12}{part}", "")?;
        }
        Ok(())
    }
}
