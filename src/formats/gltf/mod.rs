//! Files of glTF 2.0: where their parts are, what their documents say, and the numbers in them, for
//! readers of motion and of splats.
//!
//! The crate `gltf` does not serve: it loses the names of extensions' attributes, which splats are
//! in, and refuses a whole file for a fault in a material. Its accessors subtract from counts of 0,
//! add offsets without looking for overflow and unwrap sparse values that may not be there, and
//! nothing in it bounds the memory that a document takes.

mod accessor;
mod buffers;
pub mod document;
mod glb;

pub use accessor::FLOAT;
pub use buffers::GltfFile;
pub use document::{Document, entry, parse};
pub use glb::parts;
