//! What a crash leaves behind: a line in the log, and a file that the next start reads.

use super::log;
use std::{
    fs,
    path::{Path, PathBuf},
};
use tracing::Level;

/// What the file of a crash is called until the next start has read it, and afterwards.
const FRESH: &str = "crash.txt";
const READ: &str = "crash-last.txt";

/// What an earlier run left.
pub struct Report {
    /// All of it, to be shared.
    pub text: String,
    path: PathBuf,
}

impl Report {
    /// For the panel: what happened, in a line, and where all of it is.
    pub fn summary(&self) -> String {
        let first = self.text.lines().next().unwrap_or_default();
        format!("Effigy crashed last time: {first}. Share it, or find it in {}", self.path.display())
    }
}

/// From now on a panic goes to the log, and to a file in the first of `folders` that takes it. Also hands out what an earlier run left there.
pub fn watch(folders: &[PathBuf]) -> Option<Report> {
    let mine = folders.to_vec();
    std::panic::set_hook(Box::new(move |panic| {
        let thread = std::thread::current();
        let commit = option_env!("EFFIGY_COMMIT").unwrap_or("unknown");
        let version = env!("CARGO_PKG_VERSION");
        let text = format!("{panic}\nthread {}, Effigy {version}, commit {commit}\n", thread.name().unwrap_or("without a name"));
        log::write(Level::ERROR, &text);
        let written = mine.iter().map(|folder| folder.join(FRESH)).find(|path| fs::write(path, &text).is_ok());
        match written {
            Some(path) => log::write(Level::ERROR, &format!("written to {}", path.display())),
            None => log::write(Level::ERROR, "no folder took the crash's file"),
        }
    }));
    folders.iter().find_map(|folder| take(folder))
}

fn take(folder: &Path) -> Option<Report> {
    let (fresh, path) = (folder.join(FRESH), folder.join(READ));
    let text = fs::read_to_string(&fresh).ok()?;
    // Said once: where it can't be renamed it is removed, or every start would complain.
    let _ = fs::rename(&fresh, &path).or_else(|_| fs::remove_file(&fresh));
    Some(Report { text, path })
}
