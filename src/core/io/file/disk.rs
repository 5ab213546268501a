//! Reading and writing whole files.

use super::error::{FileError, FormatError};
use crate::random::hash;
use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Reads a file and decodes it.
pub fn read_with<T>(
    path: &Path,
    decode: impl FnOnce(&[u8]) -> Result<T, FormatError>,
) -> Result<T, FileError> {
    let failed = |cause| FileError::Read {
        file: path.into(),
        cause,
    };
    let file = File::open(path).map_err(failed)?;
    if !file.metadata().map_err(failed)?.is_file() {
        return Err(failed(io::Error::other(
            "found a folder or device, expected a file",
        )));
    }
    let bytes = bytes_of(file).map_err(failed)?;
    decode(&bytes).map_err(|fault| FileError::Content {
        file: path.into(),
        fault,
    })
}

/// The bytes of a file, mapped: they are read on access.
#[cfg(all(feature = "mmap", not(target_arch = "wasm32")))]
fn bytes_of(file: File) -> io::Result<memmap2::Mmap> {
    // SAFETY: the mapping is only read. Should another program shorten the file meanwhile, the
    // system ends this process; this one never does, as it replaces files whole.
    unsafe { memmap2::Mmap::map(&file) }
}

/// The bytes of a file.
#[cfg(not(all(feature = "mmap", not(target_arch = "wasm32"))))]
fn bytes_of(mut file: File) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    io::Read::read_to_end(&mut file, &mut bytes)?;
    Ok(bytes)
}

/// Writes encoded bytes to a file, whole or not at all.
pub fn write_encoded(path: &Path, bytes: Result<Vec<u8>, FormatError>) -> Result<(), FileError> {
    let bytes = bytes.map_err(|fault| FileError::Content {
        file: path.into(),
        fault,
    })?;
    replace(path, &bytes)
}

/// Replaces a file with [`write_whole`], with an error that names it.
///
/// # Errors
/// When the file cannot be written, for example because the disk is full. A file that was at `path`
/// is then unchanged.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    write_whole(path, bytes).map_err(|cause| FileError::Write {
        file: path.into(),
        cause,
    })
}

/// Writes a file beside `path` and renames it, so that the target is either the old file or the
/// whole new one. Links are followed and stay; a pipe or device is written to. Files that killed
/// programs left of such writes are overwritten.
///
/// # Errors
/// When the file cannot be written, or `path` is an open descriptor of a program, as
/// `/dev/stderr`, and not a name of it. A file that was at `path` is then unchanged.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let Some(mut part) = PartialFile::beside(path)? else {
        return fs::write(path, bytes);
    };
    part.file.write_all(bytes)?;
    part.file.sync_all()?;
    fs::rename(&part.path, &part.target)?;
    part.is_over = true;
    Ok(())
}

/// Says before the work whether [`write_whole`] could write a file, which it leaves as it is.
///
/// # Errors
/// When its folder is missing or cannot be written to, or there is something that cannot be
/// replaced.
pub fn check_writable(path: &Path) -> io::Result<()> {
    if path.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    PartialFile::beside(path).map(drop)
}

/// Links that lead to links, at most.
const LINKS: usize = 40;

/// Whether a path leads to what a program has open, as `/dev/stderr` and `/dev/fd/3` do: another
/// program may go on writing to that.
fn is_open_file(path: &Path) -> bool {
    let mut path = path.to_owned();
    for _ in 0..LINKS {
        let above = path.parent().unwrap_or(Path::new(""));
        let folder = fs::canonicalize(Path::new(".").join(above));
        if folder.is_ok_and(|folder| folder.starts_with("/proc")) {
            return true;
        }
        let Ok(to) = fs::read_link(&path) else {
            return false;
        };
        path = above.join(to);
    }
    false
}

/// Where a file is, or would be: absolute, with every link followed.
///
/// # Errors
/// When its folder is missing, or links lead in a circle.
pub fn place(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..LINKS {
        if let Ok(whole) = fs::canonicalize(&path) {
            return Ok(whole);
        }
        let above = path.parent().unwrap_or(Path::new(""));
        if let Ok(to) = fs::read_link(&path) {
            path = above.join(to);
            continue;
        }
        let name = path.file_name().ok_or(io::ErrorKind::InvalidInput)?;
        return Ok(fs::canonicalize(Path::new(".").join(above))?.join(name));
    }
    Err(io::Error::other("links that lead in a circle"))
}

/// A file that is being written, beside the one that it is to replace. Dropping it before that
/// removes it.
struct PartialFile {
    path: PathBuf,
    /// Locked while it is written, so that abandoned files can be recognised.
    file: File,
    target: PathBuf,
    is_over: bool,
}

impl PartialFile {
    /// None if the path names a pipe or a device, which can only be written to.
    fn beside(path: &Path) -> io::Result<Option<Self>> {
        let found = fs::metadata(path).ok();
        if found.as_ref().is_some_and(|found| !found.is_file()) {
            return Ok(None);
        }
        if found.as_ref().is_some_and(|f| f.permissions().readonly()) {
            return Err(io::Error::new(
                io::ErrorKind::PermissionDenied,
                "it is write-protected",
            ));
        }
        if found.is_some() && is_open_file(path) {
            return Err(io::Error::other(
                "it is a file that a program has open: give the file's own name",
            ));
        }
        let target = place(path)?;
        // Two programs, or threads, may write one file: each has a part of its own.
        let part = (0..).find_map(|number| Self::open(&target, number).transpose());
        let part = part.ok_or(io::ErrorKind::ResourceBusy)??;
        if let Some(found) = found {
            // Permissions are worth keeping, but no reason not to write the file.
            part.file.set_permissions(found.permissions()).ok();
        }
        Ok(Some(part))
    }

    /// None if the file with that number is being written.
    fn open(target: &Path, number: u64) -> io::Result<Option<Self>> {
        let path = target.with_file_name(part_name(target, number));
        let mut options = File::options();
        options.write(true);
        let (file, is_new) = match options.clone().create_new(true).open(&path) {
            Ok(file) => (file, true),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                match options.open(&path) {
                    Ok(file) => (file, false),
                    Err(_) => return Ok(None),
                }
            }
            Err(error) => return Err(error),
        };
        let is_own = match file.try_lock() {
            // Another may have locked, written and renamed it before the lock was had, also what was
            // created here.
            Ok(()) => is_at(&file, &path),
            Err(TryLockError::WouldBlock) => false,
            // There are no locks here.
            Err(TryLockError::Error(_)) => is_new,
        };
        if !is_own {
            return Ok(None);
        }
        file.set_len(0)?;
        Ok(Some(Self {
            path,
            file,
            target: target.into(),
            is_over: false,
        }))
    }
}

impl Drop for PartialFile {
    fn drop(&mut self) {
        if !self.is_over {
            // A failed removal is not reported: the user must see the first failure.
            fs::remove_file(&self.path).ok();
        }
    }
}

/// A name that hides, and that a file system takes however long the target's is.
fn part_name(target: &Path, number: u64) -> OsString {
    /// Bytes of a name that leave room for the rest.
    const LONG: usize = 200;
    let mut name = OsString::from(".");
    let own = target.file_name().unwrap_or_default();
    if own.len() > LONG {
        let sum = own.as_encoded_bytes().iter();
        let sum = sum.fold(0, |sum, &byte| hash(sum ^ u64::from(byte)));
        name.push(format!("{sum:016x}"));
    } else {
        name.push(own);
    }
    if number > 0 {
        name.push(format!(".{number}"));
    }
    name.push(".part");
    name
}

/// Whether an open file is still the one of that name.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let of = |found: fs::Metadata| [found.dev(), found.ino()];
    let open = file.metadata().map(of);
    open.is_ok_and(|open| fs::symlink_metadata(path).is_ok_and(|found| of(found) == open))
}

#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    path.exists()
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::thread;

    fn names(folder: &Path) -> usize {
        fs::read_dir(folder).unwrap().count()
    }

    #[test]
    fn a_file_is_replaced_and_nothing_is_left_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a.json".to_owned(), "l".repeat(255)] {
            let path = folder.path().join(name);
            for text in ["first, and longer", "second"] {
                check_writable(&path).unwrap();
                write_whole(&path, text.as_bytes()).unwrap();
                assert_eq!(fs::read_to_string(&path).unwrap(), text);
            }
        }
        assert_eq!(names(folder.path()), 2);
        let private = folder.path().join("private");
        write_whole(&private, b"old").unwrap();
        fs::set_permissions(&private, fs::Permissions::from_mode(0o600)).unwrap();
        write_whole(&private, b"new").unwrap();
        let mode = private.metadata().unwrap().permissions().mode();
        assert_eq!(mode & 0o777, 0o600);
    }

    #[test]
    fn what_can_not_be_replaced_is_refused_and_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("kept");
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
        let circle = folder.path().join("circle");
        symlink("circle", &circle).unwrap();
        for path in [
            &path,
            &path.join("below"),
            &folder.path().join("none/a"),
            folder.path(),
            &circle,
        ] {
            assert!(check_writable(path).is_err(), "{path:?}");
            assert!(write_whole(path, b"new").is_err(), "{path:?}");
        }
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(names(folder.path()), 2);
    }

    #[test]
    fn links_are_followed_and_devices_written_to() {
        let folder = tempfile::tempdir().unwrap();
        let [file, link, far] = ["file", "link", "far"].map(|name| folder.path().join(name));
        symlink("far", &link).unwrap();
        symlink("file", &far).unwrap();
        // The first time the links lead nowhere.
        for text in ["old", "new"] {
            write_whole(&link, text.as_bytes()).unwrap();
            assert_eq!(fs::read_to_string(&file).unwrap(), text);
            assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        }
        check_writable(Path::new("/dev/null")).unwrap();
        write_whole(Path::new("/dev/null"), b"gone").unwrap();
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn what_a_program_has_open_is_not_replaced() {
        use std::os::fd::AsRawFd;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("log");
        fs::write(&path, "old").unwrap();
        let open = File::options().append(true).open(&path).unwrap();
        let number = open.as_raw_fd();
        let link = folder.path().join("link");
        symlink(format!("/dev/fd/{number}"), &link).unwrap();
        for name in ["/dev/fd", "/proc/self/fd", "/proc/thread-self/fd"] {
            let name = Path::new(name).join(number.to_string());
            assert!(check_writable(&name).is_err(), "{name:?}");
            assert!(write_whole(&name, b"new").is_err(), "{name:?}");
        }
        assert!(write_whole(&link, b"new").is_err());
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        // A pipe is written to.
        let (mut from, to) = io::pipe().unwrap();
        let pipe = PathBuf::from(format!("/dev/fd/{}", to.as_raw_fd()));
        check_writable(&pipe).unwrap();
        write_whole(&pipe, b"new").unwrap();
        drop(to);
        let mut read = String::new();
        io::Read::read_to_string(&mut from, &mut read).unwrap();
        assert_eq!(read, "new");
        assert_eq!(names(folder.path()), 2);
    }

    #[test]
    fn what_a_kill_left_is_written_over_and_what_is_being_written_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        let part = folder.path().join(".a.part");
        fs::write(&part, "half of a file that was killed").unwrap();
        write_whole(&path, b"whole").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "whole");
        assert_eq!(names(folder.path()), 1);
        let other = PartialFile::beside(&path).unwrap().unwrap();
        write_whole(&path, b"beside").unwrap();
        assert!(part.exists() && names(folder.path()) == 2);
        drop(other);
        assert_eq!(names(folder.path()), 1);
    }

    #[test]
    fn many_writers_of_one_file_leave_the_whole_of_one() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        thread::scope(|scope| {
            for letter in b'a'..b'i' {
                let path = &path;
                scope.spawn(move || {
                    for length in 1..20 {
                        write_whole(path, &vec![letter; 1000 * length]).unwrap();
                    }
                });
            }
        });
        let found = fs::read(&path).unwrap();
        assert!(found.iter().all(|&byte| byte == found[0]) && found.len() >= 1000);
        assert_eq!(names(folder.path()), 1);
    }
}
