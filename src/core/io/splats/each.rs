//! Work on every Gaussian of a file, on all cores where there are threads.

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
