//! One training a folder: a file that says who works there, renewed while it does.

use serde::{Deserialize, Serialize};
use std::fs::{self, File, TryLockError};
use std::io::{self, Seek, Write};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// Interval of heartbeats.
const HEARTBEAT: Duration = Duration::from_secs(5);
/// A process without a heartbeat for this long is considered dead.
const DEAD_AFTER: Duration = Duration::from_secs(30);

/// The process that trains in a folder.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Worker {
    /// The process.
    pub pid: u32,
    /// Its machine.
    pub host: String,
    /// How many have worked here since the last that ended in order, this one included.
    pub attempt: u32,
    /// Seconds since 1970 of its last heartbeat.
    pub heartbeat: u64,
}

/// Why a folder can't be locked.
#[derive(Debug, thiserror::Error)]
pub enum LockError {
    /// Another process trains there.
    #[error("{folder}: process {} on {} is training there (attempt {}, alive {seconds} s ago)", worker.pid, worker.host, worker.attempt)]
    Taken {
        /// The folder.
        folder: String,
        /// The other process.
        worker: Worker,
        /// Since its last heartbeat.
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

/// A folder that nobody else trains in, for as long as this lives: its lock is held open, which
/// processes of this machine see at once, and renewed, which those of others see.
pub struct Lock {
    /// Held by the system for as long as it is open.
    held: File,
    stop: Arc<AtomicBool>,
    heart: Option<JoinHandle<()>>,
    /// How many have worked here since the last that ended in order, this one included.
    pub attempt: u32,
}

impl Lock {
    /// Takes a folder.
    ///
    /// # Errors
    /// When somebody works there, on this machine or, by a heartbeat within half a minute,
    /// elsewhere, or the folder can't be written.
    pub fn take(folder: &Path) -> Result<Self, LockError> {
        let path = folder.join("lock.json");
        let failed = |cause: io::Error| LockError::Io {
            file: path.display().to_string(),
            cause,
        };
        let mut open = fs::OpenOptions::new();
        let mut held = open
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(&path)
            .map_err(failed)?;
        let mut text = Vec::new();
        io::Read::read_to_end(&mut held, &mut text).map_err(failed)?;
        let known = serde_json::from_slice::<Worker>(&text).ok();
        let mut attempt = 1;
        // Where the system can't lock files, heartbeats have to do.
        let locking = held.try_lock();
        let taken = matches!(locking, Err(TryLockError::WouldBlock));
        let locks = locking.is_ok();
        if let Some(worker) = &known {
            attempt = worker.attempt.saturating_add(1);
        }
        let here = known.as_ref().is_none_or(|worker| worker.host == host());
        let seconds = known
            .as_ref()
            .map_or(0, |worker| now().abs_diff(worker.heartbeat));
        let trusted = here && locks;
        if taken || known.is_some() && !trusted && seconds < DEAD_AFTER.as_secs() {
            return Err(LockError::Taken {
                folder: folder.display().to_string(),
                worker: known.unwrap_or_else(|| Worker::here(0)),
                seconds,
            });
        }
        write(&mut held, attempt).map_err(failed)?;
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = stop.clone();
        let mut beating = held.try_clone().map_err(failed)?;
        let heart = std::thread::spawn(move || {
            let step = Duration::from_millis(100);
            let mut waited = Duration::ZERO;
            while !stopped.load(Ordering::Relaxed) {
                std::thread::sleep(step);
                waited += step;
                if waited >= HEARTBEAT {
                    waited = Duration::ZERO;
                    // A disk that is full now may not be at the next beat.
                    write(&mut beating, attempt).ok();
                }
            }
        });
        Ok(Self {
            held,
            stop,
            heart: Some(heart),
            attempt,
        })
    }

    /// The lock's file: to be emptied where the program ends without dropping the lock.
    ///
    /// # Errors
    /// When the process has no room for another file.
    pub fn file(&self) -> io::Result<File> {
        self.held.try_clone()
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        if let Some(heart) = self.heart.take() {
            heart.join().ok();
        }
        // Emptied, not removed: another process may have it open already, and would lock a file
        // that is no longer the lock.
        self.held.set_len(0).ok();
    }
}

impl Worker {
    /// This process.
    fn here(attempt: u32) -> Self {
        Self {
            pid: std::process::id(),
            host: host(),
            attempt,
            heartbeat: now(),
        }
    }
}

/// Writes a heartbeat.
fn write(file: &mut File, attempt: u32) -> io::Result<()> {
    let text = serde_json::to_vec(&Worker::here(attempt))?;
    file.rewind()?;
    file.write_all(&text)?;
    file.set_len(text.len() as u64)
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
