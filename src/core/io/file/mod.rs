//! `NAME.avatar` and `NAME.motion`: reading and writing of [`Avatar`](crate::avatar::Avatar) and
//! [`Clip`](crate::avatar::Clip), with one sentence on what is wrong where that fails. [`mod@format`]
//! defines the files' content.

mod arrays;
mod check;
mod coding;
mod container;
mod deflate;
mod disk;
mod document;
mod encode;
mod error;
pub mod format;
mod header;
mod model_files;
mod order;
mod rules;
mod sets;
mod tensors;

pub use disk::{check_writable, place, read_with, replace, write_whole};
pub use error::{FileError, FormatError, excerpt};
pub use model_files::{FileContent, tensors, tensors_of};
pub use order::Neutral;
pub use tensors::TensorInfo;
