//! Errors of a device: each says what was found and what was expected. The program that shows the
//! error adds advice about its own options.

use crate::quirks::NO_TRIANGLES;
use ash::vk;
use std::path::PathBuf;

/// A result with this backend's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Errors of the Vulkan backend.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The Vulkan loader is missing or could not be loaded.
    #[error("no Vulkan loader on this machine ({0})")]
    NoLoader(String),
    /// No installed driver offers a device.
    #[error("no Vulkan device on this machine")]
    NoDevice,
    /// No device has the name or number that was asked for.
    #[error("no Vulkan device is called `{wanted}`; found {found}")]
    NoSuchDevice {
        /// Part of a name, or a number.
        wanted: String,
        /// The names of all devices, each in backquotes.
        found: String,
    },
    /// [`GpuOptions::statistics`](super::GpuOptions::statistics) is set and the driver reports
    /// none.
    #[error(
        "{device} does not tell what its compiler makes of shaders: its driver lacks VK_KHR_pipeline_executable_properties"
    )]
    NoStatistics {
        /// The device's name.
        device: String,
    },
    /// Work was submitted to a device opened with
    /// [`GpuOptions::statistics`](super::GpuOptions::statistics).
    #[error("{device} was opened to be asked about its shaders, so nothing can run on it")]
    AskedOnly {
        /// The device's name.
        device: String,
    },
    /// The device lacks what Effigy requires, or what an option or the window asks for.
    #[error("{device} can't serve: {missing}")]
    Unsupported {
        /// The device's name.
        device: String,
        /// The missing features.
        missing: String,
    },
    /// A graphics pipeline was needed on a driver that crashes when it draws triangles.
    #[error("{device} can't serve: {NO_TRIANGLES}")]
    NoTriangles {
        /// The device's name.
        device: String,
    },
    /// The device can't present to the window's surface.
    #[error("{device} can't present to this window")]
    NoWindow {
        /// The device's name.
        device: String,
    },
    /// No driver has the instance extensions that the window's surface needs.
    #[error("no Vulkan driver on this machine has an extension for windows of this display")]
    NoWindowExtension,
    /// Drawing over a frame, for instance of a panel, failed in the program that draws it.
    #[error("what is drawn over frames failed: {0}")]
    Overlay(String),
    /// An image was read before a frame was drawn into it.
    #[error("there is no image to read: no frame was drawn at this size")]
    NothingDrawn,
    /// No variant of the sort gave the right order in the self-test.
    #[error("no sort is right on {device}: {reasons}{}", recorded(record))]
    NoSort {
        /// The device's name.
        device: String,
        /// How each variant failed.
        reasons: String,
        /// The file that remembers it.
        record: Option<PathBuf>,
    },
    /// A buffer, or the keys of a sort, would exceed the device's limits.
    #[error("{what} takes {found} bytes; {device} allows {limit} in one buffer")]
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
    /// [`GpuOptions::validation`](super::GpuOptions::validation) is set and the validation
    /// layer is missing.
    #[error("the validation layer was asked for and is not installed")]
    NoValidation,
    /// A call failed for lack of memory.
    #[error("out of {memory} memory at {call}")]
    OutOfMemory {
        /// Whose memory: `device` or `host`.
        memory: &'static str,
        /// The Vulkan function that failed.
        call: &'static str,
    },
    /// The named call returned `VK_ERROR_DEVICE_LOST`. Open the device again.
    #[error("the device was lost at {0}: its driver reset it, or it was unplugged")]
    DeviceLost(&'static str),
    /// The named call returned `VK_ERROR_SURFACE_LOST_KHR`. Make surface and swapchain again.
    #[error("the window's surface was lost at {0}")]
    SurfaceLost(&'static str),
    /// A wait for the device reached its time limit.
    #[error("{what} did not finish within {seconds} s: the device or its driver hangs")]
    Timeout {
        /// The work that was waited for.
        what: &'static str,
        /// The time limit, seconds.
        seconds: u64,
    },
    /// A call failed with a result that no other variant stands for.
    #[error("{call} failed: {result}")]
    Call {
        /// The Vulkan function, or what it was called for.
        call: &'static str,
        /// The `VkResult` that it returned.
        code: i32,
        /// What that means.
        result: String,
    },
    /// The avatar's arrays contradict each other, or hold a number that can't be drawn.
    #[error("this avatar can't be drawn: {0}")]
    Avatar(#[from] effigy_core::io::file::FormatError),
    /// The options, a pose or the camera hold a number that no frame can be drawn with.
    #[error("this can't be drawn: {0}")]
    Unusable(#[from] effigy_core::frame::Unusable),
    /// The allocator of device memory failed, though not for lack of memory.
    #[error("allocating {what} failed: {reason}")]
    Allocation {
        /// The purpose of the memory.
        what: String,
        /// What the allocator says.
        reason: String,
    },
}

impl Error {
    /// Whether it says nothing of how is drawn: it may not happen next time or with another avatar,
    /// the options or the avatar are at fault, or a CPU was busy.
    pub(crate) fn may_pass(&self, is_cpu: bool) -> bool {
        match self {
            Self::OutOfMemory { .. }
            | Self::Allocation { .. }
            | Self::TooLarge { .. }
            | Self::ImageSize { .. }
            | Self::Unusable(_)
            | Self::Avatar(_) => true,
            Self::Timeout { .. } => is_cpu,
            _ => false,
        }
    }

    /// Whether the device can be drawn with afterwards.
    pub(crate) fn leaves_the_device(&self) -> bool {
        !matches!(self, Self::DeviceLost(_) | Self::Timeout { .. })
    }
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
    /// Turns a Vulkan error into an [`Error`]. `call`: the function that returned it.
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
            result => Error::Call {
                call,
                code: result.as_raw(),
                result: result.to_string(),
            },
        })
    }
}
