//! The files to open: a list of one folder at a time.

use egui::{Align2, ScrollArea};
use std::{
    cmp::Reverse,
    ffi::{OsStr, OsString},
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
struct FolderEntry {
    /// As the system has it, which may be no text.
    name: OsString,
    is_folder: bool,
}

/// A folder, and what is in it.
#[derive(Debug)]
pub struct Browser {
    folder: PathBuf,
    /// Folders first, by name; or why they can't be listed.
    entries: Result<Vec<FolderEntry>, String>,
}

impl Browser {
    /// Lists a folder. That of a relative path is the one that it is now.
    pub fn new(folder: PathBuf) -> Self {
        let folder = std::path::absolute(Path::new(".").join(&folder)).unwrap_or(folder);
        let entries = list(&folder).map_err(|error| error.to_string());
        Self { folder, entries }
    }

    /// The folder that is listed.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Goes into a folder, or gives the path of a file. Above the highest folder there is itself.
    fn choose(&mut self, name: &OsStr, is_folder: bool) -> Option<PathBuf> {
        let path = if name == ABOVE {
            self.folder.parent().unwrap_or(&self.folder).to_owned()
        } else {
            self.folder.join(name)
        };
        if !is_folder {
            return Some(path);
        }
        *self = Self::new(path);
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
                                entry.map_or((OsStr::new(ABOVE), true), |e| (&e.name, e.is_folder));
                            let slash = if is_folder { "/" } else { "" };
                            if ui
                                .selectable_label(false, format!("{}{slash}", name.display()))
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
fn list(folder: &Path) -> io::Result<Vec<FolderEntry>> {
    let mut entries = vec![];
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name();
        if !name.as_encoded_bytes().starts_with(b".") {
            let is_folder = entry.path().is_dir();
            entries.push(FolderEntry { name, is_folder });
        }
    }
    entries.sort_by_cached_key(|entry| {
        let name = entry.name.to_string_lossy().to_lowercase();
        (Reverse(entry.is_folder), name)
    });
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
            let name = |entry: &FolderEntry| entry.name.display().to_string();
            entries.iter().map(name).collect()
        };
        assert_eq!(names(&browser), ["z inside", "A.avatar", "b.ply"]);
        let mut choose = |name: &str, is_folder| browser.choose(name.as_ref(), is_folder);
        assert_eq!(choose("b.ply", false), Some(folder.join("b.ply")));
        assert_eq!(choose("z inside", true), None);
        assert_eq!(names(&browser), ["walk.bvh"]);
        browser.choose(ABOVE.as_ref(), true);
        assert_eq!(browser.folder(), folder);
        browser.choose(ABOVE.as_ref(), true);
        assert_eq!(names(&browser), ["scans"]);
    }

    /// Names that are no text, on systems that have them.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_file_is_opened_by_the_name_that_it_has() {
        use std::os::unix::ffi::OsStrExt;
        let root = tempfile::tempdir().expect("the system has a temporary folder");
        let name = OsStr::from_bytes(b"K\xf6ln.ply");
        fs::write(root.path().join(name), "splats").expect("it is writable");
        let mut browser = Browser::new(root.path().into());
        let entries = browser.entries.clone().expect("it can be listed");
        let chosen = browser.choose(&entries[0].name, entries[0].is_folder);
        let chosen = chosen.expect("it is a file");
        assert_eq!(fs::read(chosen).expect("it is there"), b"splats");
    }

    #[test]
    fn above_the_highest_folder_is_itself_and_above_a_relative_one_what_it_is_in() {
        let root = Path::new("/").ancestors().last().map(Path::to_owned);
        let mut browser = Browser::new(root.expect("there is a root"));
        let highest = browser.folder().to_owned();
        browser.choose(ABOVE.as_ref(), true);
        assert_eq!(browser.folder(), highest);
        let here = std::env::current_dir().expect("there is one");
        let mut browser = Browser::new("".into());
        browser.choose(ABOVE.as_ref(), true);
        assert_eq!(Some(browser.folder()), here.parent());
        let mut browser = Browser::new("src/ui".into());
        browser.choose(ABOVE.as_ref(), true);
        assert_eq!(browser.folder(), here.join("src"));
    }

    #[test]
    fn a_folder_that_can_not_be_listed_says_why() {
        let browser = Browser::new("no/such/folder".into());
        assert!(browser.entries.is_err());
    }
}
