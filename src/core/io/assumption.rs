//! What a file leaves open, and what a reader took instead.

use std::fmt;

/// A decision that a file leaves to its reader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assumption {
    /// The question, as a noun: "hidden layers".
    pub what: &'static str,
    /// The answer that was taken.
    pub taken: String,
    /// Where the answer comes from, or how to give another.
    pub because: String,
}

impl fmt::Display for Assumption {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {} ({})", self.what, self.taken, self.because)
    }
}
