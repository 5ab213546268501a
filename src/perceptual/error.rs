//! What can go wrong with the networks of ST-LPIPS.

use effigy_core::io::file::FileError;

/// Why a network can't be used.
#[derive(Debug, thiserror::Error)]
pub enum PerceptualError {
    /// The file can't be read, or holds something else than the network's weights.
    #[error(transparent)]
    File(#[from] FileError),
    /// The network computes something else than it should on this machine.
    #[error(
        "ST-LPIPS ({network}): {what} of the built-in pictures is {found}, expected {expected}"
    )]
    Wrong {
        /// The network's name.
        network: &'static str,
        /// What was worked out.
        what: &'static str,
        /// The number found.
        found: f64,
        /// The number that was worked out apart from this program.
        expected: f64,
    },
}
