//! What can go wrong with the networks.

use effigy_core::io::file::FileError;
use std::path::PathBuf;

/// Why a network can't be used.
#[derive(Debug, thiserror::Error)]
pub enum PerceptualError {
    /// The file can't be read, or holds something else than the network's weights.
    #[error(transparent)]
    File(#[from] FileError),
    /// A file is not there.
    #[error("{measure}: cannot read {}: no such file. It is {origin}", file.display())]
    Missing {
        /// What is worked out.
        measure: &'static str,
        /// Where it should be.
        file: PathBuf,
        /// Where it is from.
        origin: &'static str,
    },
    /// The network computes something else than it should on this machine.
    #[error("{measure}: {what} of the built-in pictures is {found}, expected {expected}")]
    Wrong {
        /// What is worked out.
        measure: &'static str,
        /// What was worked out.
        what: &'static str,
        /// The number found.
        found: f64,
        /// The number that was worked out apart from this program.
        expected: f64,
    },
}
