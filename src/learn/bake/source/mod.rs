//! Readers of the bake's source files. Every error names the file and, in text files, the line.

pub mod assets;
pub mod masks;
pub mod obj;
pub mod rig;
pub mod target;
pub mod text;

pub use assets::Assets;
