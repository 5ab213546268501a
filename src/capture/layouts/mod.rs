//! How captures lay out their files, one file a layout.

mod avatarrex;
mod thuman4;

use std::path::Path;

/// Where a layout has its files.
pub struct Layout {
    /// What the layout is called.
    pub name: &'static str,
    /// The file with all cameras, by which it is known.
    pub calibration: &'static str,
    /// Folder of a camera's pictures.
    pub pictures: fn(camera: &str) -> String,
    /// Folder of a camera's masks.
    pub masks: fn(camera: &str) -> String,
    /// Number of the frame that a file in these is of, from its name without ending.
    pub number: fn(stem: &str) -> Option<u32>,
}

/// Every layout that is known.
const ALL: [&Layout; 2] = [&thuman4::LAYOUT, &avatarrex::LAYOUT];

/// The layout that is written.
pub const OWN: &Layout = &thuman4::LAYOUT;

/// The layout of a folder.
pub fn of(folder: &Path) -> Option<&'static Layout> {
    ALL.into_iter()
        .find(|layout| folder.join(layout.calibration).is_file())
}

/// The files that layouts are known by.
pub fn known_by() -> String {
    ALL.map(|layout| format!("{} ({})", layout.calibration, layout.name))
        .join(" or ")
}

/// A number of at most eight digits.
fn digits(stem: &str) -> Option<u32> {
    let plain = (1..=8).contains(&stem.len()) && stem.bytes().all(|byte| byte.is_ascii_digit());
    plain.then(|| stem.parse().ok()).flatten()
}
