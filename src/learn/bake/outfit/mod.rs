//! The body's clothes, hair and face: which sheets there are, where each begins and ends, and their
//! colours before light. Lengths are metres in the rest pose.
//!
//! Everything here is painted by hand: colours are in `palette` and [`crate::bake::style`], other numbers stand where they
//! are used, with a name or a comment that says what they shape. Each noise has a seed of its own,
//! its first argument.

pub mod albedo;
pub mod emblem;
pub mod face;
pub mod garments;
mod palette;
pub mod relief;
pub mod sheets;
pub mod shoe;

pub use garments::Outfit;
pub use sheets::sheets;
