//! The avatars that the panel offers besides the one that is shown.

use crate::avatar::{Avatar, Clip};
use std::sync::Arc;

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
}

impl Shelf {
    /// `load` reads the avatar with a number in `names`; it runs on a thread of its own.
    pub fn new(names: Vec<String>, shown: usize, load: impl Fn(usize) -> anyhow::Result<Show> + Send + Sync + 'static) -> Self {
        Self { names, shown, load: Some(Arc::new(load)) }
    }

    /// Reads an avatar and hands it to `done`, from another thread. Nothing happens where there is no such avatar.
    pub fn fetch(&self, number: usize, done: impl FnOnce(anyhow::Result<Show>) + Send + 'static) {
        let Some(load) = self.load.clone().filter(|_| number < self.names.len()) else { return };
        std::thread::spawn(move || done(load(number)));
    }
}
