//! What can go wrong on a device, in sentences that say what was found, what was expected and what to do.

use ash::vk;

pub type Result<T> = std::result::Result<T, Error>;

#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(
        "no Vulkan loader on this machine ({0}): install your GPU's driver, or for a CPU driver on Debian and Ubuntu `apt-get install mesa-vulkan-drivers libvulkan1`"
    )]
    NoLoader(#[from] ash::LoadingError),
    #[error(
        "no Vulkan device on this machine: install your GPU's driver, or for a CPU driver on Debian and Ubuntu `apt-get install mesa-vulkan-drivers`"
    )]
    NoDevice,
    #[error("no Vulkan device is called `{wanted}`; found {found}")]
    NoSuchDevice { wanted: String, found: String },
    #[error(
        "{device} does not tell what its compiler makes of shaders: its driver lacks VK_KHR_pipeline_executable_properties; choose another device of `effigy devices` with --device"
    )]
    NoStatistics { device: String },
    #[error("{device} was opened to be asked about its shaders, so nothing can run on it")]
    AskedOnly { device: String },
    #[error("{device} can't serve: {lacks}; `effigy devices` lists every device and what it lacks")]
    Lacks { device: String, lacks: String },
    #[error(
        "{what} takes {found} bytes; {device} allows {limit} in one buffer: use an avatar with fewer Gaussians or rows, or another device"
    )]
    TooLarge { what: &'static str, found: u64, limit: u64, device: String },
    #[error("a picture of {found} px is outside what {device} draws: 1 to {limit} px a side")]
    PictureSize { found: String, limit: u32, device: String },
    #[error("the validation layer was asked for and is not installed: on Debian and Ubuntu `apt-get install vulkan-validationlayers`")]
    NoValidation,
    #[error("out of {memory} memory at {call}: close other programs, or use a smaller picture or avatar")]
    OutOfMemory { memory: &'static str, call: &'static str },
    #[error("the device was lost at {0}: its driver reset it, or it was unplugged")]
    DeviceLost(&'static str),
    #[error("the window's surface was lost at {0}")]
    SurfaceLost(&'static str),
    #[error("{what} did not finish within {seconds} s: the device or its driver hangs")]
    Timeout { what: &'static str, seconds: u64 },
    #[error("{call} failed: {result}")]
    Call { call: &'static str, result: vk::Result },
    #[error("this can't be drawn: {0}")]
    Unusable(#[from] crate::frame::Unusable),
    #[error("allocating {what} failed: {source}")]
    Allocation { what: String, source: gpu_allocator::AllocationError },
}

/// Names the call that a Vulkan result comes from.
pub trait During<T> {
    fn during(self, call: &'static str) -> Result<T>;
}

impl<T> During<T> for std::result::Result<T, vk::Result> {
    fn during(self, call: &'static str) -> Result<T> {
        self.map_err(|result| match result {
            vk::Result::ERROR_OUT_OF_DEVICE_MEMORY => Error::OutOfMemory { memory: "device", call },
            vk::Result::ERROR_OUT_OF_HOST_MEMORY => Error::OutOfMemory { memory: "host", call },
            vk::Result::ERROR_DEVICE_LOST => Error::DeviceLost(call),
            vk::Result::ERROR_SURFACE_LOST_KHR => Error::SurfaceLost(call),
            result => Error::Call { call, result },
        })
    }
}
