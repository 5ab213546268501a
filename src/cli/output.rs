//! Files that a command is asked to write. Their endings say what they hold; whether they can be
//! written is looked at before the work, and none replaces a file that the command reads.

use crate::backdrop::BackdropArg;
use anyhow::{Context, bail, ensure};
use clap::{
    ArgMatches,
    builder::{OsStringValueParser, TypedValueParser},
};
use effigy_core::io::file::{check_writable, place, write_whole};
use serde::Serialize;
use std::{
    collections::HashSet,
    ffi::OsString,
    fs::{self, File},
    io::{self, IsTerminal, Write},
    ops::Deref,
    path::{Path, PathBuf},
    sync::{LazyLock, Mutex, OnceLock, PoisonError},
};

/// What a file may hold.
#[derive(Debug)]
pub struct FileKind {
    /// Lower case. What has no name, the standard output or a device, gets the first.
    endings: &'static [&'static str],
    /// Whether `-` is the standard output.
    streams: bool,
}

const fn kind(endings: &'static [&'static str], streams: bool) -> FileKind {
    FileKind { endings, streams }
}

/// An image.
pub static IMAGE: FileKind = kind(&["png", "jpg", "jpeg", "webp"], true);
/// An image, or several in one.
pub static PNG: FileKind = kind(&["png"], true);
/// A report.
pub static JSON: FileKind = kind(&["json"], true);
/// A trace.
pub static TRACE: FileKind = kind(&["json"], false);
/// A table.
pub static CSV: FileKind = kind(&["csv"], true);
/// A chart.
pub static CHART: FileKind = kind(&["svg", "png"], true);
/// A page.
pub static MARKDOWN: FileKind = kind(&["md"], false);
/// An avatar.
pub static AVATAR: FileKind = kind(&["avatar"], false);
/// A clip.
pub static MOTION: FileKind = kind(&["motion"], false);
/// An avatar or a clip.
pub static IMPORTED: FileKind = kind(&["avatar", "motion"], false);
/// Splats as 3DGS writes them.
pub static PLY: FileKind = kind(&["ply"], true);
/// Splats in the format of the ending.
pub static SPLATS: FileKind = kind(&effigy_formats::splats::WRITTEN, false);
/// The paper's model.
pub static NPZ: FileKind = kind(&["npz"], false);

/// Endings of moving pictures, which none of the commands writes.
const VIDEOS: [&str; 7] = ["gif", "mp4", "mov", "avi", "mkv", "webm", "apng"];

impl FileKind {
    /// Reads the name of such a file.
    pub fn parser(&'static self) -> impl TypedValueParser<Value = Output> {
        OsStringValueParser::new().try_map(|name| self.read(name))
    }

    fn read(&self, name: OsString) -> Result<Output, String> {
        let path = PathBuf::from(name);
        let shown = path.display();
        let natural = self.endings.first().copied().unwrap_or_default();
        if STDOUTS.iter().any(|name| path.as_os_str() == *name) {
            return if self.streams {
                Ok(Output::new(STDOUT.into(), natural))
            } else {
                Err(format!(
                    "`{shown}` has no ending, and this file needs one: write {}",
                    self.names("NAME")
                ))
            };
        }
        let ending = path.extension().unwrap_or_default().to_string_lossy();
        let ending = ending.to_ascii_lowercase();
        if let Some(&known) = self.endings.iter().find(|known| **known == ending) {
            return Ok(Output::new(
                path,
                if known == "jpeg" { "jpg" } else { known },
            ));
        }
        let is_device = fs::metadata(&path).is_ok_and(|it| !it.is_file() && !it.is_dir());
        if is_device {
            return Ok(Output::new(path, natural));
        }
        let stem = path.with_extension("");
        let stem = stem.display();
        if self.endings.contains(&"webp") && VIDEOS.contains(&ending.as_str()) {
            return Err(format!(
                "`{shown}` is a moving picture, which Effigy does not write: write numbered images \
                 with --frames and --out {stem}.png, then `ffmpeg -framerate 30 -i {stem}-%04d.png \
                 -pix_fmt yuv420p {shown}`"
            ));
        }
        let names = self.names(&stem.to_string());
        Err(match ending.as_str() {
            "" if path.is_dir() => format!("`{shown}` is a folder: name a file to write in it"),
            "" => format!("`{shown}` has no ending, which says what to write: write {names}"),
            _ => format!(
                "`{shown}` does not end in .{}: write {names}",
                self.endings.join(", .")
            ),
        })
    }

    /// A name with each ending.
    fn names(&self, stem: &str) -> String {
        let name = |ending: &&str| format!("{stem}.{ending}");
        let mut all: Vec<String> = self.endings.iter().map(name).collect();
        if self.streams {
            all.push("- for the standard output".into());
        }
        all.join(" or ")
    }
}

/// A file to write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    path: PathBuf,
    ending: &'static str,
}

/// The name of the standard output, and those that systems give it: under these it could be a file
/// that others have written to as well, and would be replaced.
const STDOUT: &str = "-";
const STDOUTS: [&str; 4] = [STDOUT, "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

impl Deref for Output {
    type Target = Path;

    fn deref(&self) -> &Path {
        &self.path
    }
}

impl AsRef<Path> for Output {
    fn as_ref(&self) -> &Path {
        self
    }
}

impl Output {
    /// A file whose name nobody gave. `ending`: its own, lower case.
    pub fn new(path: PathBuf, ending: &'static str) -> Self {
        Self { path, ending }
    }

    /// The ending that says what it holds: lower case, "jpg" for .jpeg.
    pub fn ending(&self) -> &'static str {
        self.ending
    }

    /// Whether it is the standard output, which has nothing else then.
    pub fn is_stdout(&self) -> bool {
        self.path.as_os_str() == STDOUT
    }

    /// `walk.png` and 7 give `walk-0007.png`.
    pub fn numbered(&self, number: usize) -> Self {
        self.renamed(
            |stem, ending| format!("{stem}-{number:04}.{ending}"),
            self.ending,
        )
    }

    /// A file beside it: `a.avatar` and `loss.csv` give `a.loss.csv`.
    pub fn beside(&self, rest: &'static str) -> Self {
        let ending = rest.rsplit('.').next().unwrap_or(rest);
        self.renamed(|stem, _| format!("{stem}.{rest}"), ending)
    }

    fn renamed(&self, name: impl Fn(&str, &str) -> String, ending: &'static str) -> Self {
        let stem = self.path.file_stem().unwrap_or_default().to_string_lossy();
        let own = self.path.extension().unwrap_or_default().to_string_lossy();
        let own = if own.is_empty() { self.ending } else { &own };
        Self::new(self.path.with_file_name(name(&stem, own)), ending)
    }

    /// Writes it: whole, or not at all.
    pub fn write(&self, bytes: impl AsRef<[u8]>) -> anyhow::Result<()> {
        let written = if self.is_stdout() {
            print_bytes(bytes.as_ref())
        } else {
            write_whole(&self.path, bytes.as_ref())
        };
        written.with_context(|| format!("{} can't be written", self.path.display()))
    }

    /// Writes a value as indented JSON.
    pub fn write_json(&self, value: &impl Serialize) -> anyhow::Result<()> {
        self.write(serde_json::to_string_pretty(value)? + "\n")
    }

    /// Writes what is known of a value so far, unless that is for the standard output: a file is
    /// not lost if the program is stopped.
    pub fn keep_json(&self, value: &impl Serialize) -> anyhow::Result<()> {
        if self.is_stdout() {
            return Ok(());
        }
        self.write_json(value)
    }
}

/// Arguments for the one file that a command makes: `--out FILE`, or FILE behind what it is made of.
macro_rules! write_arguments {
    ($name:ident, $kind:ident, $what:literal) => {
        #[derive(clap::Args, Debug)]
        pub struct $name {
            #[doc = $what]
            #[arg(short, long, value_name = "FILE", required_unless_present = "behind", value_parser = $kind.parser())]
            out: Option<Output>,
            /// The same without `--out`
            #[arg(hide = true, conflicts_with = "out", value_parser = $kind.parser())]
            behind: Option<Output>,
        }

        impl $name {
            /// The file.
            pub fn file(&self) -> anyhow::Result<&Output> {
                let file = self.out.as_ref().or(self.behind.as_ref());
                file.context("no file to write: name one with --out")
            }
        }
    };
}
write_arguments!(WriteAvatar, AVATAR, "Avatar file to write");
write_arguments!(WriteMotion, MOTION, "Motion file to write");
write_arguments!(WriteImported, IMPORTED, "Avatar or motion file to write");
write_arguments!(
    WritePly,
    PLY,
    ".ply file to write, or - for the standard output"
);
write_arguments!(
    WriteSplats,
    SPLATS,
    "File to write, in the format that its ending names: .ply, .spz, .splat or .glb"
);

/// A folder to write to, which may not be there yet.
#[derive(Clone, Debug)]
pub struct OutputFolder(PathBuf);

impl From<OsString> for OutputFolder {
    fn from(name: OsString) -> Self {
        Self(name.into())
    }
}

impl Deref for OutputFolder {
    type Target = Path;

    fn deref(&self) -> &Path {
        &self.0
    }
}

impl OutputFolder {
    fn check(&self) -> anyhow::Result<()> {
        let there = self.0.ancestors().find(|above| above.exists());
        let there = there.unwrap_or(Path::new("."));
        ensure!(
            there.is_dir(),
            "{} can't be made: {} is a file",
            self.0.display(),
            there.display()
        );
        check_writable(&there.join("effigy"))
            .or_else(|error| match error.kind() {
                io::ErrorKind::IsADirectory => Ok(()),
                _ => Err(error),
            })
            .with_context(|| format!("{} can't be written to", there.display()))
    }
}

/// What the command reads and writes.
#[derive(Default)]
struct FileNames {
    /// Where the files are that it reads.
    inputs: Vec<PathBuf>,
    /// Where those are that it writes, in lower case: some systems don't tell them apart.
    outputs: HashSet<String>,
    may_overwrite: bool,
}

static NAMES: LazyLock<Mutex<FileNames>> = LazyLock::new(Mutex::default);

/// What was the standard output before all that is printed went to standard error.
static PIPE: OnceLock<File> = OnceLock::new();

/// Checks all files and folders that the arguments of a command name. Paths are what it reads;
/// [`Output`] and [`OutputFolder`] are what it writes.
pub fn check_arguments(matches: &ArgMatches) -> anyhow::Result<()> {
    let mut outputs: Vec<&Output> = Vec::new();
    let mut next = Some(matches);
    while let Some(matches) = next {
        for id in matches.ids() {
            let id = id.as_str();
            if let Ok(Some(found)) = matches.try_get_many::<PathBuf>(id) {
                names()
                    .inputs
                    .extend(found.filter_map(|path| place(path).ok()));
            }
            if let Ok(Some(found)) = matches.try_get_many::<BackdropArg>(id) {
                let pictures = found.filter_map(BackdropArg::picture);
                names()
                    .inputs
                    .extend(pictures.filter_map(|path| place(path).ok()));
            }
            if let Ok(Some(found)) = matches.try_get_many::<Output>(id) {
                outputs.extend(found);
            }
            if let Ok(Some(mut found)) = matches.try_get_many::<OutputFolder>(id) {
                found.try_for_each(OutputFolder::check)?;
            }
        }
        names().may_overwrite |= matches.get_flag("overwrite");
        next = matches.subcommand().map(|(_, matches)| matches);
    }
    check(outputs.iter().copied())?;
    match outputs.iter().find(|output| output.is_stdout()) {
        Some(output) => take_stdout(output),
        None => Ok(()),
    }
}

fn names() -> std::sync::MutexGuard<'static, FileNames> {
    NAMES.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether the user said that what is there may be lost.
pub fn may_overwrite() -> bool {
    names().may_overwrite
}

/// Checks files that a command writes besides those of its arguments, before the work.
pub fn check<'a>(outputs: impl IntoIterator<Item = &'a Output>) -> anyhow::Result<()> {
    let mut names = names();
    outputs.into_iter().try_for_each(|output| names.add(output))
}

/// Checks a series of files, numbered as `out` is, before the work.
pub fn check_series<'a>(
    out: &Output,
    series: impl IntoIterator<Item = &'a Output>,
) -> anyhow::Result<()> {
    ensure!(
        !out.is_stdout(),
        "the standard output takes one image, not a series: name a file with --out"
    );
    check(series)
}

impl FileNames {
    fn add(&mut self, output: &Output) -> anyhow::Result<()> {
        let path = &output.path;
        let shown = path.display();
        let is_device = fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir());
        if is_device {
            return Ok(());
        }
        let place = if output.is_stdout() {
            path.clone()
        } else {
            ensure!(!path.is_dir(), "{shown} is a folder: name a file to write");
            let above = path.parent().filter(|above| *above != Path::new(""));
            if let Some(above) = above.filter(|above| !above.is_dir()) {
                let above_shown = above.display();
                ensure!(
                    !above.exists(),
                    "{shown} can't be written: {above_shown} is no folder"
                );
                bail!("{shown} can't be written: there is no folder {above_shown}");
            }
            check_writable(path).with_context(|| format!("{shown} can't be written"))?;
            place(path)?
        };
        ensure!(
            self.outputs.insert(place.to_string_lossy().to_lowercase()),
            "{shown} would be written twice: give each file a name of its own"
        );
        let is_input = self.inputs.iter().any(|input| is_same(input, &place));
        ensure!(
            self.may_overwrite || !is_input,
            "{shown} is read by this command and would be replaced: name another file, or add \
             --overwrite"
        );
        Ok(())
    }
}

/// Whether two places are one file, under one name or two.
fn is_same(a: &Path, b: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let of = |path| fs::metadata(path).map(|found: fs::Metadata| [found.dev(), found.ino()]);
        if let (Ok(a), Ok(b)) = (of(a), of(b)) {
            return a == b;
        }
    }
    a == b
}

/// Keeps the standard output for a file: what is printed from now on goes to standard error.
fn take_stdout(output: &Output) -> anyhow::Result<()> {
    let is_text = ["json", "csv", "md", "svg"].contains(&output.ending);
    if !is_text && io::stdout().is_terminal() {
        bail!(
            "a .{} is no text for a terminal: name a file with --out, or send it on with `| …` or `> …`",
            output.ending
        );
    }
    #[cfg(unix)]
    {
        use std::os::fd::AsFd;
        let pipe = io::stdout().as_fd().try_clone_to_owned()?;
        // SAFETY: both descriptors are open, and no lock of the standard output is held.
        let moved = unsafe { libc::dup2(libc::STDERR_FILENO, libc::STDOUT_FILENO) };
        ensure!(moved >= 0, io::Error::last_os_error());
        // Arguments are checked once.
        let _ = PIPE.set(pipe.into());
    }
    Ok(())
}

fn print_bytes(bytes: &[u8]) -> io::Result<()> {
    let printed = match PIPE.get() {
        Some(mut pipe) => pipe.write_all(bytes),
        None => io::stdout().lock().write_all(bytes),
    };
    // As a shell reports SIGPIPE: who reads has enough.
    if printed
        .as_ref()
        .is_err_and(|error| error.kind() == io::ErrorKind::BrokenPipe)
    {
        std::process::exit(141);
    }
    printed
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(kind: &FileKind, name: &str) -> Result<Output, String> {
        kind.read(name.into())
    }

    #[test]
    fn an_ending_is_read_in_any_case_and_one_that_is_missing_is_named() {
        for (name, ending) in [("a.PNG", "png"), ("b.c/a.jpeg", "jpg"), ("-", "png")] {
            assert_eq!(read(&IMAGE, name).unwrap().ending(), ending);
        }
        let shown = read(&SPLATS, "b/a.obj").unwrap_err();
        assert!(shown.contains("b/a.ply or b/a.spz"), "{shown}");
        for name in STDOUTS {
            assert!(read(&IMAGE, name).unwrap().is_stdout());
            assert!(read(&AVATAR, name).is_err_and(|error| error.contains("NAME.avatar")));
        }
        assert!(read(&IMAGE, "b/a.mov").is_err_and(|error| error.contains("b/a-%04d.png")));
    }

    #[cfg(unix)]
    #[test]
    fn a_device_needs_no_ending() {
        assert_eq!(read(&IMAGE, "/dev/null").unwrap().ending(), "png");
    }

    #[test]
    fn names_are_numbered_before_the_ending_and_others_stand_beside() {
        let image = read(&IMAGE, "out/walk.PNG").unwrap();
        assert_eq!(&*image.numbered(7), Path::new("out/walk-0007.PNG"));
        let avatar = read(&AVATAR, "out/a.b.avatar").unwrap();
        let curve = avatar.beside("loss.csv");
        assert_eq!(&*curve, Path::new("out/a.b.loss.csv"));
        assert_eq!(curve.ending(), "csv");
    }
}
