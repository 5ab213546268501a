//! How captures lay out their files, one file a layout.

mod avatarrex;
mod layout;
mod thuman4;

pub use layout::{FolderLayout, only_number};
use std::path::Path;

/// Every layout that is known.
const ALL: [&FolderLayout; 2] = [&thuman4::LAYOUT, &avatarrex::LAYOUT];

/// The layout that is written.
pub const OWN: &FolderLayout = &thuman4::LAYOUT;

/// The layout of a folder.
pub fn of(folder: &Path) -> Option<&'static FolderLayout> {
    ALL.into_iter()
        .find(|layout| folder.join(layout.calibration).is_file())
}

/// The files that layouts are known by.
pub fn known_by() -> String {
    ALL.map(|layout| format!("{} ({})", layout.calibration, layout.name))
        .join(" or ")
}
