//! Screenshots: writes an image to a PNG file with a name that was free.

use effigy_core::io::file::write_whole;
use image::{ImageFormat, RgbaImage};
use std::{
    fs::{self, File},
    io::{self, Cursor},
    path::{Path, PathBuf},
    thread::JoinHandle,
};

/// File names that are tried in one folder.
const NAMES: u32 = 10_000;

/// Threads that write screenshots, so that no frame waits for a file.
#[derive(Default)]
pub struct ScreenshotWriters(Vec<JoinHandle<()>>);

impl ScreenshotWriters {
    /// Makes an image and writes it, on another thread. There it prints the file's path, or why
    /// nothing was saved, and passes this text to `report`.
    pub fn start(
        &mut self,
        folders: Vec<PathBuf>,
        image: impl FnOnce() -> RgbaImage + Send + 'static,
        report: impl FnOnce(String) + Send + 'static,
    ) {
        self.0.retain(|writer| !writer.is_finished());
        self.0.push(std::thread::spawn(move || {
            let message = match save(&image(), &folders) {
                Ok(path) => format!("saved {}", path.display()),
                Err(error) => format!("no screenshot was saved: {error}"),
            };
            println!("{message}");
            report(message);
        }));
    }

    /// Waits for files that are being written.
    pub fn finish(&mut self) {
        for writer in self.0.drain(..) {
            if writer.join().is_err() {
                tracing::warn!("a screenshot was not saved: its thread ended early");
            }
        }
    }
}

/// Folders for screenshots: the current one, then the user's pictures.
pub fn folders() -> Vec<PathBuf> {
    let pictures =
        directories::UserDirs::new().and_then(|dirs| dirs.picture_dir().map(Path::to_path_buf));
    std::env::current_dir()
        .into_iter()
        .chain(pictures)
        .collect()
}

/// Writes an image to `effigy-0001.png` or the next name that is free, in the first folder that can
/// be written to. Returns the path.
///
/// # Errors
/// If no folder can be written to: the last one's error.
pub fn save(image: &RgbaImage, folders: &[PathBuf]) -> io::Result<PathBuf> {
    let mut bytes = Cursor::new(Vec::new());
    image
        .write_to(&mut bytes, ImageFormat::Png)
        .map_err(io::Error::other)?;
    let mut refused = io::Error::other("there is no folder to write a screenshot to");
    for folder in folders {
        match take_name(folder) {
            Ok(path) => {
                let written = write_whole(&path, bytes.get_ref());
                if written.is_err() {
                    // The name was taken for nothing.
                    fs::remove_file(&path).ok();
                }
                return written.map(|()| path);
            }
            Err(error) => {
                refused = io::Error::new(error.kind(), format!("{}: {error}", folder.display()))
            }
        }
    }
    Err(refused)
}

/// Takes a name that was free with an empty file, even if two programs look for one at once.
fn take_name(folder: &Path) -> io::Result<PathBuf> {
    for number in 1..=NAMES {
        let path = folder.join(format!("effigy-{number:04}.png"));
        match File::create_new(&path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            result => return result.map(|_| path),
        }
    }
    Err(io::Error::new(
        io::ErrorKind::AlreadyExists,
        format!("it holds {NAMES} screenshots already"),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_screenshot_overwrites_nothing_and_reads_back_exactly() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let image = |value| RgbaImage::from_pixel(3, 2, image::Rgba([value, 2, 3, 255]));
        let folders = [folder.path().join("missing"), folder.path().to_path_buf()];
        for value in [10, 20, 30] {
            let path = save(&image(value), &folders).expect("the folder is writable");
            assert_eq!(
                path,
                folder.path().join(format!("effigy-{:04}.png", value / 10))
            );
            assert_eq!(
                image::open(&path).expect("it is an image").to_rgba8(),
                image(value)
            );
        }
    }

    #[test]
    fn a_folder_that_can_not_be_written_to_is_named() {
        let missing = PathBuf::from("no-such-folder");
        let error = save(&RgbaImage::new(1, 1), &[missing])
            .expect_err("the folder is missing")
            .to_string();
        assert!(error.contains("no-such-folder"), "{error}");
        assert!(save(&RgbaImage::new(1, 1), &[]).is_err());
    }
}
