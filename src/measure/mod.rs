//! What the program says about itself in numbers: how far a picture is from the oracle's, and how visible that is.

pub mod error;
pub mod flip;
