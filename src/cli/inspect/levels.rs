//! Levels of detail, in numbers.

use super::text::thousands;
use effigy_core::avatar::{Level, LevelError};
use serde::Serialize;
use std::fmt;

/// A level's size and errors.
#[derive(Serialize)]
pub struct LevelSummary {
    gaussians: usize,
    /// Whether networks move it.
    correctives: bool,
    color_rows: usize,
    measured: Vec<LevelError>,
}

impl LevelSummary {
    pub fn new(level: &Level) -> Self {
        Self {
            gaussians: level.gaussians.len(),
            correctives: level.correctives,
            color_rows: level.color_rows.gaussian.len(),
            measured: level.measured.clone(),
        }
    }
}

impl fmt::Display for LevelSummary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let moved = if self.correctives {
            format!(
                "moved by networks, {} basis rows of colour",
                thousands(self.color_rows)
            )
        } else {
            "without networks".into()
        };
        writeln!(
            f,
            "level       {} Gaussians, {moved}",
            thousands(self.gaussians)
        )?;
        for error in &self.measured {
            writeln!(
                f,
                "{:12}{:>4} px tall, {} × {} samples a pixel: {:.1} dB, mean colour {:+.1} %, coverage {:+.1} %",
                "",
                error.height,
                error.samples,
                error.samples,
                error.psnr_db,
                100.0 * error.color,
                100.0 * error.coverage
            )?;
        }
        Ok(())
    }
}
