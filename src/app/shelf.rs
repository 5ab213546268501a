//! The avatars that the panel offers besides the one that is shown.

use crate::avatar::{Avatar, Clip};
use std::{
    sync::{
        Arc,
        atomic::{AtomicU64, Ordering},
    },
    thread::JoinHandle,
};

/// An avatar, and at least one clip for it.
pub type Show = (Avatar, Vec<Clip>);
type Load = dyn Fn(usize) -> anyhow::Result<Show> + Send + Sync;

/// Names of avatars, and how to get one. The default is empty.
#[derive(Clone, Default)]
pub struct Shelf {
    pub names: Vec<String>,
    load: Option<Arc<Load>>,
    /// Which of them is shown.
    pub shown: usize,
    /// How many were asked for so far: only the last one is wanted.
    asked: Arc<AtomicU64>,
}

impl Shelf {
    /// `load` reads the avatar with a number in `names`; it runs on a thread of its own.
    pub fn new(names: Vec<String>, shown: usize, load: impl Fn(usize) -> anyhow::Result<Show> + Send + Sync + 'static) -> Self {
        Self { names, load: Some(Arc::new(load)), shown, asked: Arc::default() }
    }

    /// Reads an avatar and hands it to `done`, from another thread; not where another was asked for meanwhile. None, and nothing happens, where
    /// there is no such avatar.
    pub fn fetch(&self, number: usize, done: impl FnOnce(anyhow::Result<Show>) + Send + 'static) -> Option<JoinHandle<()>> {
        let load = self.load.clone().filter(|_| number < self.names.len())?;
        let (asked, mine) = (self.asked.clone(), self.asked.fetch_add(1, Ordering::AcqRel) + 1);
        Some(std::thread::spawn(move || {
            let read = load(number);
            if asked.load(Ordering::Acquire) == mine {
                done(read);
            }
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc;

    /// The first one that is asked for takes longer than the second.
    #[test]
    fn the_last_one_that_was_asked_for_wins() {
        let (go, wait) = mpsc::channel::<()>();
        let wait = std::sync::Mutex::new(wait);
        let names = ["slow", "fast"].map(String::from).to_vec();
        let shelf = Shelf::new(names, 0, move |number| {
            if number == 0 {
                wait.lock().unwrap().recv()?;
            }
            anyhow::bail!("{number}")
        });
        let (tell, told) = mpsc::channel();
        let fetch = |number: usize| {
            let tell = tell.clone();
            shelf.fetch(number, move |read| tell.send(read.err().map(|error| error.to_string())).unwrap())
        };
        assert!(fetch(2).is_none());
        let (slow, fast) = (fetch(0).unwrap(), fetch(1).unwrap());
        fast.join().unwrap();
        go.send(()).unwrap();
        slow.join().unwrap();
        fetch(1).unwrap().join().unwrap();
        drop(tell);
        assert_eq!(told.try_iter().flatten().collect::<Vec<_>>(), ["1", "1"], "the slow one was no longer wanted");
    }
}
