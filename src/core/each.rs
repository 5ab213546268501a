//! Work on every Gaussian, part or vertex of an avatar: on all cores with the feature `rayon`, where
//! there are threads.

#[cfg(all(feature = "rayon", not(target_arch = "wasm32")))]
pub use on_all_cores::*;
#[cfg(not(all(feature = "rayon", not(target_arch = "wasm32"))))]
pub use on_one_core::*;

#[cfg(all(feature = "rayon", not(target_arch = "wasm32")))]
mod on_all_cores {
    use rayon::prelude::*;

    /// `of` every index below `count`, in order.
    pub fn map<T: Send>(count: usize, of: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
        (0..count).into_par_iter().map(of).collect()
    }

    /// `of` every piece of a list, `size` long but for the last, with its index.
    pub fn chunk<T: Send>(list: &mut [T], size: usize, of: impl Fn(usize, &mut [T]) + Sync + Send) {
        let pieces = list.par_chunks_mut(size).enumerate();
        pieces.for_each(|(at, piece)| of(at, piece));
    }

    /// Both results, at once.
    pub fn join<A: Send, B: Send>(
        first: impl FnOnce() -> A + Send,
        second: impl FnOnce() -> B + Send,
    ) -> (A, B) {
        rayon::join(first, second)
    }
}

#[cfg(not(all(feature = "rayon", not(target_arch = "wasm32"))))]
mod on_one_core {
    /// `of` every index below `count`, in order.
    pub fn map<T>(count: usize, of: impl Fn(usize) -> T) -> Vec<T> {
        (0..count).map(of).collect()
    }

    /// `of` every piece of a list, `size` long but for the last, with its index. Browsers don't need
    /// it.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn chunk<T>(list: &mut [T], size: usize, of: impl Fn(usize, &mut [T])) {
        for (at, piece) in list.chunks_mut(size).enumerate() {
            of(at, piece);
        }
    }

    /// Both results.
    pub fn join<A, B>(first: impl FnOnce() -> A, second: impl FnOnce() -> B) -> (A, B) {
        (first(), second())
    }
}
