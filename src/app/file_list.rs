//! The avatars that the panel offers, and how to read one without holding up the window.

use effigy_core::avatar::{Avatar, Clip};
use std::{
    sync::{
        Arc,
        atomic::{AtomicU64, Ordering},
    },
    thread::JoinHandle,
};

/// An avatar that was read, with at least one clip for it.
pub struct LoadedAvatar {
    /// The avatar.
    pub avatar: Avatar,
    /// Its clips, never empty.
    pub clips: Vec<Clip>,
}

/// Reads the avatar with an index.
type Load = dyn Fn(usize) -> anyhow::Result<LoadedAvatar> + Send + Sync;

/// Names of avatars, and how to read them. The default list is empty.
#[derive(Clone, Default)]
pub struct FileList {
    /// Each avatar's name in the panel.
    pub names: Vec<String>,
    /// Index of the avatar that is shown.
    pub shown: usize,
    load: Option<Arc<Load>>,
    /// Number of the latest request: only its avatar is delivered.
    latest_request: Arc<AtomicU64>,
}

impl FileList {
    /// `load` reads the avatar with an index into `names`, on a thread of its own.
    pub fn new(
        names: Vec<String>,
        shown: usize,
        load: impl Fn(usize) -> anyhow::Result<(Avatar, Vec<Clip>)> + Send + Sync + 'static,
    ) -> Self {
        let load = move |index| {
            let (avatar, clips) = load(index)?;
            Ok(LoadedAvatar { avatar, clips })
        };
        Self {
            names,
            shown,
            load: Some(Arc::new(load)),
            latest_request: Arc::default(),
        }
    }

    /// Index of the avatar after the one that is shown; the first follows the last.
    pub fn next(&self) -> usize {
        (self.shown + 1) % self.names.len().max(1)
    }

    /// Reads an avatar on another thread and passes it to `deliver` there, unless another one was
    /// requested meanwhile. Returns None, and does nothing, if the index is out of range.
    pub fn request(
        &self,
        index: usize,
        deliver: impl FnOnce(anyhow::Result<LoadedAvatar>) + Send + 'static,
    ) -> Option<JoinHandle<()>> {
        if index >= self.names.len() {
            return None;
        }
        let load = self.load.clone()?;
        let latest_request = self.latest_request.clone();
        let request = latest_request.fetch_add(1, Ordering::AcqRel) + 1;
        Some(std::thread::spawn(move || {
            let loaded = load(index);
            if latest_request.load(Ordering::Acquire) == request {
                deliver(loaded);
            }
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::{Mutex, mpsc};

    #[test]
    fn only_the_latest_request_is_delivered() {
        let (release_slow, slow_released) = mpsc::channel::<()>();
        let slow_released = Mutex::new(slow_released);
        let names = ["slow", "fast"].map(String::from).to_vec();
        let files = FileList::new(names, 0, move |index| {
            if index == 0 {
                slow_released.lock().unwrap().recv()?;
            }
            anyhow::bail!("{index}")
        });
        let (send, receive) = mpsc::channel();
        let request = |index: usize| {
            let send = send.clone();
            files.request(index, move |loaded| {
                send.send(loaded.err().map(|error| error.to_string()))
                    .unwrap();
            })
        };
        assert!(request(2).is_none());
        let slow = request(0).unwrap();
        let fast = request(1).unwrap();
        fast.join().unwrap();
        release_slow.send(()).unwrap();
        slow.join().unwrap();
        request(1).unwrap().join().unwrap();
        drop(send);
        assert_eq!(
            receive.try_iter().flatten().collect::<Vec<_>>(),
            ["1", "1"],
            "the slow one was superseded"
        );
    }
}
