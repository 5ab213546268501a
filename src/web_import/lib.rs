//! The library for JavaScript that turns files of other programs into Effigy's own, so that what a
//! page loads at first has none of their readers. `page/import_worker.js` calls it, in a worker that
//! ends with the file: nothing else should.
//!
//! Bytes go in, the bytes of an `.avatar` or a `.motion` come out, with sentences on what the file
//! left open; errors are sentences.

pub mod body;
#[cfg(target_arch = "wasm32")]
mod exports;
pub mod import;
