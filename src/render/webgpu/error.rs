//! Errors of a device: each says what was found and what was expected. The program that shows the
//! error adds advice about its own options.

/// A result with this backend's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Errors of the WebGPU backend.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// No device could be opened, for the reason given.
    #[error("no WebGPU device: {0}")]
    NoDevice(String),
    /// No device's name contains what was asked for.
    #[error("no WebGPU device is called `{wanted}`; found {found}")]
    NoSuchDevice {
        /// Part of a name.
        wanted: String,
        /// The names of all devices, each in backquotes.
        found: String,
    },
    /// A buffer, or the keys of the sort, would exceed the device's limits.
    #[error("{what} takes {found} bytes; {device} allows {limit} in one binding")]
    TooLarge {
        /// The purpose of the memory.
        what: &'static str,
        /// Bytes asked for.
        found: u64,
        /// Most bytes allowed.
        limit: u64,
        /// The device's name.
        device: String,
    },
    /// An image with an empty side, or one longer than the device draws, was asked for.
    #[error("an image of {found} px is outside what {device} draws: 1 to {limit} px a side")]
    ImageSize {
        /// Width and height asked for, px: `640 × 960`.
        found: String,
        /// Longest side allowed, px.
        limit: u32,
        /// The device's name.
        device: String,
    },
    /// A pipeline that draws triangles was needed on a driver that crashes when it draws them.
    #[error("{device} can't serve: {missing}")]
    Unsupported {
        /// The device's name.
        device: String,
        /// The fault of its driver.
        missing: &'static str,
    },
    /// The options ask for [`SortVariant::OneSweep`](effigy_core::frame::SortVariant::OneSweep).
    #[error("the WebGPU backend has no OneSweep, which needs subgroups")]
    Sort,
    /// The options ask for
    /// [`RasterMethod::CooperativeTiles`](effigy_core::frame::RasterMethod::CooperativeTiles).
    #[error("the WebGPU backend has no cooperative tiles, which need subgroups")]
    CooperativeTiles,
    /// The device was lost or closed, for the reason given.
    #[error("the device was lost: {0}")]
    DeviceLost(String),
    /// A wait for the device reached its time limit.
    #[error("{what} did not finish within {seconds} s: the device or its driver hangs")]
    Timeout {
        /// The work that was waited for.
        what: &'static str,
        /// The time limit, seconds.
        seconds: u64,
    },
    /// The device reported that a command is invalid, failed or ran out of memory.
    #[error("the device refused a command: {0}")]
    Refused(String),
    /// The avatar's arrays contradict each other, or hold a number that can't be drawn.
    #[error("this avatar can't be drawn: {0}")]
    Avatar(#[from] effigy_core::io::file::FormatError),
    /// The options, a pose or the camera hold a number that no frame can be drawn with.
    #[error("this can't be drawn: {0}")]
    Unusable(#[from] effigy_core::frame::Unusable),
}
