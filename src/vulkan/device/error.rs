//! What can go wrong on a device: what was found and what was expected. What a user may do about it
//! is for the program that shows the error to say.

use crate::quirks::NO_TRIANGLES;
use ash::vk;
use std::path::PathBuf;

/// A result with this backend's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Errors of the Vulkan backend.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("no Vulkan loader on this machine ({0})")]
    NoLoader(#[from] ash::LoadingError),
    #[error("no Vulkan device on this machine")]
    NoDevice,
    #[error("no Vulkan device is called `{wanted}`; found {found}")]
    NoSuchDevice { wanted: String, found: String },
    #[error(
        "{device} does not tell what its compiler makes of shaders: its driver lacks VK_KHR_pipeline_executable_properties"
    )]
    NoStatistics { device: String },
    #[error("{device} was opened to be asked about its shaders, so nothing can run on it")]
    AskedOnly { device: String },
    #[error("{device} can't serve: {missing}")]
    Unsupported { device: String, missing: String },
    #[error("{device} can't serve: {NO_TRIANGLES}")]
    NoTriangles { device: String },
    #[error("{device} can't present to this window")]
    NoWindow { device: String },
    #[error("no Vulkan driver on this machine has an extension for windows of this display")]
    NoWindowExtension,
    /// An image was read before a frame was drawn into it.
    #[error("there is no image to read: no frame was drawn at this size")]
    NothingDrawn,
    /// No variant of the sort gave the right order in the self-test.
    #[error("no sort is right on {device}: {reasons}{}", recorded(record))]
    NoSort {
        device: String,
        /// How each variant failed.
        reasons: String,
        /// The file that remembers it.
        record: Option<PathBuf>,
    },
    #[error("{what} takes {found} bytes; {device} allows {limit} in one buffer")]
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
    #[error("the validation layer was asked for and is not installed")]
    NoValidation,
    #[error("out of {memory} memory at {call}")]
    OutOfMemory {
        memory: &'static str,
        call: &'static str,
    },
    #[error("the device was lost at {0}: its driver reset it, or it was unplugged")]
    DeviceLost(&'static str),
    #[error("the window's surface was lost at {0}")]
    SurfaceLost(&'static str),
    #[error("{what} did not finish within {seconds} s: the device or its driver hangs")]
    Timeout { what: &'static str, seconds: u64 },
    #[error("{call} failed: {result}")]
    Call {
        call: &'static str,
        result: vk::Result,
    },
    #[error("this can't be drawn: {0}")]
    Unusable(#[from] effigy_core::frame::Unusable),
    #[error("allocating {what} failed: {source}")]
    Allocation {
        what: String,
        source: gpu_allocator::AllocationError,
    },
}

/// Where the record of the tests lies, as the end of a sentence.
fn recorded(record: &Option<PathBuf>) -> String {
    match record {
        Some(path) => format!(" (recorded in {})", path.display()),
        None => String::new(),
    }
}

/// Names the call that a Vulkan result comes from.
pub trait During<T> {
    fn during(self, call: &'static str) -> Result<T>;
}

impl<T> During<T> for std::result::Result<T, vk::Result> {
    fn during(self, call: &'static str) -> Result<T> {
        self.map_err(|result| match result {
            vk::Result::ERROR_OUT_OF_DEVICE_MEMORY => Error::OutOfMemory {
                memory: "device",
                call,
            },
            vk::Result::ERROR_OUT_OF_HOST_MEMORY => Error::OutOfMemory {
                memory: "host",
                call,
            },
            vk::Result::ERROR_DEVICE_LOST => Error::DeviceLost(call),
            vk::Result::ERROR_SURFACE_LOST_KHR => Error::SurfaceLost(call),
            result => Error::Call { call, result },
        })
    }
}
