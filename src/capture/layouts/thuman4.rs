//! THuman4.0, which is also what others' tools write of own captures.

use super::layout::{FolderLayout, digits};

pub const LAYOUT: FolderLayout = FolderLayout {
    name: "THuman4",
    calibration: "calibration.json",
    pictures: |camera| format!("images/{camera}"),
    masks: |camera| format!("masks/{camera}"),
    number: digits,
};
