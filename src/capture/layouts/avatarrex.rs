//! AvatarReX: a folder a camera, with the masks inside.

use super::layout::{FolderLayout, digits};

pub const LAYOUT: FolderLayout = FolderLayout {
    name: "AvatarReX",
    calibration: "calibration_full.json",
    pictures: |camera| camera.to_owned(),
    masks: |camera| format!("{camera}/mask/pha"),
    number: digits,
};
