//! The files to open: a list of one folder at a time.

use egui::{Align2, ScrollArea};
use std::{
    cmp::Reverse,
    fs, io,
    path::{Path, PathBuf},
};

/// Width and height of the list, points.
const WIDTH: f32 = 360.0;
const HEIGHT: f32 = 360.0;
/// What the folder above is called.
const ABOVE: &str = "..";

/// A file or folder of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Entry {
    name: String,
    is_folder: bool,
}

/// A folder, and what is in it.
#[derive(Debug)]
pub struct Browser {
    folder: PathBuf,
    /// Folders first, by name; or why they can't be listed.
    entries: Result<Vec<Entry>, String>,
}

impl Browser {
    /// Lists a folder.
    pub fn new(folder: PathBuf) -> Self {
        let entries = list(&folder).map_err(|error| error.to_string());
        Self { folder, entries }
    }

    /// The folder that is listed.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Goes into a folder, or gives the path of a file.
    fn choose(&mut self, name: &str, is_folder: bool) -> Option<PathBuf> {
        if !is_folder {
            return Some(self.folder.join(name));
        }
        let folder = match self.folder.parent() {
            Some(parent) if name == ABOVE => parent.to_owned(),
            _ => self.folder.join(name),
        };
        *self = Self::new(folder);
        None
    }

    /// Lays the list out. Returns the file that was chosen.
    pub fn show(&mut self, ctx: &egui::Context) -> Option<PathBuf> {
        let mut clicked = None;
        egui::Window::new("Open a file")
            .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
            .collapsible(false)
            .resizable(false)
            .show(ctx, |ui| {
                ui.set_width(WIDTH);
                ui.label(self.folder.display().to_string());
                ui.separator();
                let entries = match &self.entries {
                    Ok(entries) => entries,
                    Err(error) => {
                        ui.label(error);
                        &vec![]
                    }
                };
                let row = ui.text_style_height(&egui::TextStyle::Button);
                let rows = entries.len() + 1;
                ScrollArea::vertical()
                    .max_height(HEIGHT)
                    .auto_shrink(false)
                    .show_rows(ui, row, rows, |ui, range| {
                        for index in range {
                            let entry = index.checked_sub(1).and_then(|index| entries.get(index));
                            let (name, is_folder) =
                                entry.map_or((ABOVE, true), |entry| (&entry.name, entry.is_folder));
                            let slash = if is_folder { "/" } else { "" };
                            if ui
                                .selectable_label(false, format!("{name}{slash}"))
                                .clicked()
                            {
                                clicked = Some((name.to_owned(), is_folder));
                            }
                        }
                    });
            });
        clicked.and_then(|(name, is_folder)| self.choose(&name, is_folder))
    }
}

/// What is in a folder but hidden files.
fn list(folder: &Path) -> io::Result<Vec<Entry>> {
    let mut entries = vec![];
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if !name.starts_with('.') {
            let is_folder = entry.path().is_dir();
            entries.push(Entry { name, is_folder });
        }
    }
    entries.sort_by_cached_key(|entry| (Reverse(entry.is_folder), entry.name.to_lowercase()));
    Ok(entries)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_come_first_and_a_file_is_chosen_below_them() {
        let root = tempfile::tempdir().expect("the system has a temporary folder");
        let folder = root.path().join("scans");
        fs::create_dir_all(folder.join("z inside")).expect("it is writable");
        for name in ["b.ply", "A.avatar", ".hidden", "z inside/walk.bvh"] {
            fs::write(folder.join(name), "").expect("it is writable");
        }
        let mut browser = Browser::new(folder.clone());
        let names = |browser: &Browser| -> Vec<String> {
            let entries = browser.entries.as_ref().expect("it can be listed");
            entries.iter().map(|entry| entry.name.clone()).collect()
        };
        assert_eq!(names(&browser), ["z inside", "A.avatar", "b.ply"]);
        assert_eq!(browser.choose("b.ply", false), Some(folder.join("b.ply")));
        assert_eq!(browser.choose("z inside", true), None);
        assert_eq!(names(&browser), ["walk.bvh"]);
        browser.choose(ABOVE, true);
        assert_eq!(browser.folder(), folder);
        browser.choose(ABOVE, true);
        assert_eq!(names(&browser), ["scans"]);
    }

    #[test]
    fn a_folder_that_can_not_be_listed_says_why() {
        let browser = Browser::new("no/such/folder".into());
        assert!(browser.entries.is_err());
    }
}
