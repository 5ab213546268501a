//! What the program says about itself in numbers: how far a picture is from the oracle's.

pub mod error;
