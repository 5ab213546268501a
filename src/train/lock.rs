//! One training a folder: a file that says who works there, renewed while it does.

use effigy_core::io::file::replace;
use serde::{Deserialize, Serialize};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// From one sign of life to the next.
const BEAT: Duration = Duration::from_secs(5);
/// Who has given none for so long is gone.
const GONE: Duration = Duration::from_secs(30);

/// Who works in a folder.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Worker {
    /// The process.
    pub pid: u32,
    /// Its machine.
    pub host: String,
    /// How many have worked here, this one included.
    pub attempt: u32,
    /// Seconds since 1970 of its last sign of life.
    pub heartbeat: u64,
}

/// Why a folder can't be had.
#[derive(Debug, thiserror::Error)]
pub enum LockError {
    /// Somebody works there.
    #[error("{folder}: process {} on {} is training there (attempt {}, alive {seconds} s ago)", worker.pid, worker.host, worker.attempt)]
    Taken {
        /// The folder.
        folder: String,
        /// Who.
        worker: Worker,
        /// Since its last sign of life.
        seconds: u64,
    },
    /// It can't be written.
    #[error("{file}: {cause}")]
    Io {
        /// The lock.
        file: String,
        /// What the system says.
        cause: io::Error,
    },
}

/// A folder that nobody else trains in, for as long as this lives.
pub struct Lock {
    file: PathBuf,
    stop: Arc<AtomicBool>,
    heart: Option<JoinHandle<()>>,
    /// How many have worked here, this one included.
    pub attempt: u32,
}

impl Lock {
    /// Takes a folder.
    ///
    /// # Errors
    /// When somebody works there who has given a sign of life within half a minute, or the folder
    /// can't be written.
    pub fn take(folder: &Path) -> Result<Self, LockError> {
        let file = folder.join("lock.json");
        let failed = |cause: io::Error| LockError::Io {
            file: file.display().to_string(),
            cause,
        };
        let mut attempt = 1;
        match fs::read(&file) {
            Ok(bytes) => {
                if let Ok(worker) = serde_json::from_slice::<Worker>(&bytes) {
                    let seconds = now().saturating_sub(worker.heartbeat);
                    let ended = worker.host == host() && !is_alive(worker.pid);
                    if !ended && seconds < GONE.as_secs() {
                        return Err(LockError::Taken {
                            folder: folder.display().to_string(),
                            worker,
                            seconds,
                        });
                    }
                    attempt = worker.attempt + 1;
                }
                fs::remove_file(&file).map_err(failed)?;
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => return Err(failed(error)),
        }
        let worker = move || Worker {
            pid: std::process::id(),
            host: host(),
            attempt,
            heartbeat: now(),
        };
        let text = move || serde_json::to_vec(&worker()).unwrap_or_default();
        // Of two that come at once one makes the file.
        let mut open = fs::OpenOptions::new();
        let mut new = open
            .write(true)
            .create_new(true)
            .open(&file)
            .map_err(failed)?;
        io::Write::write_all(&mut new, &text()).map_err(failed)?;
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = stop.clone();
        let path = file.clone();
        let heart = std::thread::spawn(move || {
            let step = Duration::from_millis(100);
            let mut waited = Duration::ZERO;
            while !stopped.load(Ordering::Relaxed) {
                std::thread::sleep(step);
                waited += step;
                if waited >= BEAT {
                    waited = Duration::ZERO;
                    // A disk that is full now may not be at the next beat.
                    let _ = replace(&path, &text());
                }
            }
        });
        Ok(Self {
            file,
            stop,
            heart: Some(heart),
            attempt,
        })
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        if let Some(heart) = self.heart.take() {
            let _ = heart.join();
        }
        let _ = fs::remove_file(&self.file);
    }
}

fn now() -> u64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.map_or(0, |since| since.as_secs())
}

/// The machine's name, where the system says it.
fn host() -> String {
    let name = fs::read_to_string("/proc/sys/kernel/hostname");
    name.map_or_else(|_| String::new(), |name| name.trim().to_string())
}

/// Whether a process of this machine runs; where the system does not say, it may.
fn is_alive(pid: u32) -> bool {
    !Path::new("/proc/self").exists() || Path::new(&format!("/proc/{pid}")).exists()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_has_one_worker_and_a_dead_one_gives_way() {
        let folder = tempfile::tempdir().unwrap();
        let first = Lock::take(folder.path()).unwrap();
        assert_eq!(first.attempt, 1);
        let second = Lock::take(folder.path()).err().unwrap();
        assert!(matches!(second, LockError::Taken { .. }), "{second}");
        drop(first);
        assert_eq!(Lock::take(folder.path()).unwrap().attempt, 1);
        let dead = Worker {
            pid: 1,
            host: "elsewhere".into(),
            attempt: 4,
            heartbeat: now() - 1000,
        };
        let file = folder.path().join("lock.json");
        fs::write(&file, serde_json::to_vec(&dead).unwrap()).unwrap();
        assert_eq!(Lock::take(folder.path()).unwrap().attempt, 5);
        fs::write(&file, b"not a lock").unwrap();
        assert_eq!(Lock::take(folder.path()).unwrap().attempt, 1);
    }
}
