//! The avatars that the panel offers, and how to read one without holding up the window.

use effigy_core::avatar::{Avatar, Clip};
use std::{
    path::{Path, PathBuf},
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

impl LoadedAvatar {
    /// An avatar with those of some clips that move a joint of it: with one that stands still if
    /// there are none.
    pub fn new(avatar: Avatar, mut clips: Vec<Clip>) -> Self {
        clips.retain(|clip| clip.map_to(&avatar.skeleton).iter().any(Option::is_some));
        if clips.is_empty() {
            clips.push(Clip::still(&avatar.skeleton));
        }
        Self { avatar, clips }
    }
}

/// Reads an avatar.
type Load = dyn Fn() -> anyhow::Result<LoadedAvatar> + Send + Sync;

/// An avatar of the list.
#[derive(Clone)]
struct ListedAvatar {
    /// What the panel calls it.
    name: String,
    /// Its file, of those that were added.
    path: Option<PathBuf>,
    load: Arc<Load>,
}

/// Names of avatars, and how to read them. The default list is empty.
#[derive(Clone, Default)]
pub struct FileList {
    entries: Vec<ListedAvatar>,
    /// Index of the avatar that is shown.
    pub shown: usize,
    /// Number of the latest request: only its avatar is delivered.
    latest_request: Arc<AtomicU64>,
}

/// What the panel calls an avatar's file.
pub fn stem(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

impl FileList {
    /// `load` reads the avatar with an index into `names`, on a thread of its own.
    pub fn new(
        names: Vec<String>,
        shown: usize,
        load: impl Fn(usize) -> anyhow::Result<LoadedAvatar> + Send + Sync + 'static,
    ) -> Self {
        let load = Arc::new(load);
        let entry = |(index, name)| {
            let load = load.clone();
            ListedAvatar {
                name,
                path: None,
                load: Arc::new(move || load(index)),
            }
        };
        Self {
            entries: names.into_iter().enumerate().map(entry).collect(),
            shown,
            latest_request: Arc::default(),
        }
    }

    /// Each avatar's name in the panel.
    pub fn names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.entries.iter().map(|entry| entry.name.as_str())
    }

    /// Adds an avatar's file, unless it was added before, and gives its index. `load` reads it
    /// again, on a thread of its own.
    pub fn add(
        &mut self,
        path: &Path,
        load: impl Fn() -> anyhow::Result<LoadedAvatar> + Send + Sync + 'static,
    ) -> usize {
        let is_same = |entry: &ListedAvatar| entry.path.as_deref() == Some(path);
        if let Some(known) = self.entries.iter().position(is_same) {
            return known;
        }
        self.entries.push(ListedAvatar {
            name: stem(path),
            path: Some(path.to_owned()),
            load: Arc::new(load),
        });
        self.entries.len() - 1
    }

    /// Index of the avatar after the one that is shown; the first follows the last. None if there
    /// is no other.
    pub fn next(&self) -> Option<usize> {
        let count = self.entries.len();
        (count > 1).then(|| (self.shown + 1) % count)
    }

    /// Number of the latest request.
    pub fn latest_request(&self) -> u64 {
        self.latest_request.load(Ordering::Acquire)
    }

    /// Makes a request that takes the place of the one before, and gives its number.
    pub fn begin_request(&self) -> u64 {
        self.latest_request.fetch_add(1, Ordering::AcqRel) + 1
    }

    /// Reads an avatar on another thread and passes it to `deliver` there, unless another one was
    /// requested meanwhile. Returns None, and does nothing, if the index is out of range.
    pub fn request(
        &self,
        index: usize,
        deliver: impl FnOnce(anyhow::Result<LoadedAvatar>) + Send + 'static,
    ) -> Option<JoinHandle<()>> {
        let load = self.entries.get(index)?.load.clone();
        let request = self.begin_request();
        let latest_request = self.latest_request.clone();
        Some(std::thread::spawn(move || {
            let loaded = load();
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

    #[test]
    fn a_file_that_is_added_twice_is_listed_once() {
        let mut files = FileList::new(vec!["first".into()], 0, |_| anyhow::bail!("listed"));
        assert_eq!(files.next(), None);
        let mut add = |path: &str| files.add(Path::new(path), || anyhow::bail!("added"));
        let added = ["a/x.avatar", "b/x.avatar", "a/x.avatar"].map(&mut add);
        assert_eq!(added, [1, 2, 1]);
        assert_eq!(files.names().collect::<Vec<_>>(), ["first", "x", "x"]);
        files.shown = 2;
        assert_eq!(files.next(), Some(0));
        let (send, receive) = mpsc::channel();
        for index in [0, 2] {
            let send = send.clone();
            let deliver = move |loaded: anyhow::Result<LoadedAvatar>| {
                send.send(loaded.err().map(|error| error.to_string()))
                    .unwrap();
            };
            files.request(index, deliver).unwrap().join().unwrap();
        }
        drop(send);
        assert_eq!(
            receive.iter().flatten().collect::<Vec<_>>(),
            ["listed", "added"]
        );
    }
}
