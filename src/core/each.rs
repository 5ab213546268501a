//! Work on every Gaussian, part or vertex of an avatar, on all cores where there are threads.

#[cfg(not(target_arch = "wasm32"))]
use rayon::prelude::*;

/// `of` every index below `count`, in order.
#[cfg(not(target_arch = "wasm32"))]
pub fn map<T: Send>(count: usize, of: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    (0..count).into_par_iter().map(of).collect()
}

/// `of` every index below `count`, in order.
#[cfg(target_arch = "wasm32")]
pub fn map<T>(count: usize, of: impl Fn(usize) -> T) -> Vec<T> {
    (0..count).map(of).collect()
}

/// Both results, at once where there are threads.
#[cfg(not(target_arch = "wasm32"))]
pub fn join<A: Send, B: Send>(
    first: impl FnOnce() -> A + Send,
    second: impl FnOnce() -> B + Send,
) -> (A, B) {
    rayon::join(first, second)
}

/// Both results, at once where there are threads.
#[cfg(target_arch = "wasm32")]
pub fn join<A, B>(first: impl FnOnce() -> A, second: impl FnOnce() -> B) -> (A, B) {
    (first(), second())
}
