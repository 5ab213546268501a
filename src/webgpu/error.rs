//! What can go wrong on a device: what was found and what was expected. The program that shows the
//! error adds advice about its own options.

/// A result with this backend's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Errors of the WebGPU backend.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    #[error("no WebGPU device: {0}")]
    NoDevice(String),
    #[error("no WebGPU device is called `{wanted}`; found {found}")]
    NoSuchDevice { wanted: String, found: String },
    #[error("{what} takes {found} bytes; {device} allows {limit} in one binding")]
    TooLarge {
        what: &'static str,
        found: u64,
        limit: u64,
        device: String,
    },
    #[error("an image of {found} px is outside what {device} draws: 1 to {limit} px a side")]
    ImageSize {
        found: String,
        limit: u32,
        device: String,
    },
    #[error("{device} can't serve: {missing}")]
    Unsupported {
        device: String,
        missing: &'static str,
    },
    #[error("the WebGPU backend sorts keys of 16 bits, not of {0}")]
    KeyBits(u32),
    #[error("the WebGPU backend has no OneSweep, which needs subgroups")]
    Sort,
    #[error("the device was lost: {0}")]
    DeviceLost(String),
    #[error("{what} did not finish within {seconds} s: the device or its driver hangs")]
    Timeout { what: &'static str, seconds: u64 },
    #[error("the device refused a command: {0}")]
    Refused(String),
    #[error("this can't be drawn: {0}")]
    Unusable(#[from] effigy_core::frame::Unusable),
}
