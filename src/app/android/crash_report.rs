//! Reports of crashes: a line in the log, and a file that the next start reads.

use super::log;
use std::{
    fs,
    path::{Path, PathBuf},
};
use tracing::Level;

/// Name of a report that has not been read yet.
const UNREAD: &str = "crash.txt";
/// Name of the last report that was read.
const READ: &str = "crash-last.txt";

/// The report of an earlier run's crash.
pub struct CrashReport {
    /// All of it, to be shared.
    pub text: String,
    path: PathBuf,
}

impl CrashReport {
    /// A line for the panel: what happened, and where the report is.
    pub fn summary(&self) -> String {
        let first = self.text.lines().next().unwrap_or_default();
        format!(
            "Effigy crashed last time: {first}. Share it, or find it in {}",
            self.path.display()
        )
    }
}

/// Reports panics from now on: to the log, and to a file in the first of `folders` that can be
/// written to. Returns the report of an earlier run, if there is a new one.
pub fn install(folders: &[PathBuf]) -> Option<CrashReport> {
    let report_folders = folders.to_vec();
    std::panic::set_hook(Box::new(move |panic| {
        let thread = std::thread::current();
        let commit = option_env!("EFFIGY_COMMIT").unwrap_or("unknown");
        let version = env!("CARGO_PKG_VERSION");
        let text = format!(
            "{panic}\nthread {}, Effigy {version}, commit {commit}\n",
            thread.name().unwrap_or("without a name")
        );
        log::write(Level::ERROR, &text);
        let written = report_folders
            .iter()
            .map(|folder| folder.join(UNREAD))
            .find(|path| fs::write(path, &text).is_ok());
        match written {
            Some(path) => log::write(Level::ERROR, &format!("written to {}", path.display())),
            None => log::write(
                Level::ERROR,
                "the report could not be written to any folder",
            ),
        }
    }));
    folders.iter().find_map(|folder| take_report(folder))
}

/// Reads a new report, and renames it.
fn take_report(folder: &Path) -> Option<CrashReport> {
    let unread = folder.join(UNREAD);
    let path = folder.join(READ);
    let text = fs::read_to_string(&unread).ok()?;
    // A file that can't be renamed is removed: it would be reported at every start.
    let _ = fs::rename(&unread, &path).or_else(|_| fs::remove_file(&unread));
    Some(CrashReport { text, path })
}
