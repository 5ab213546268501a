//! Advice to the user on an error. The library's errors state facts; flags, commands and
//! packages are known here alone.

use effigy_learn::bake;
use effigy_measure::bench::BackendError;
use effigy_render::vulkan;
#[cfg(feature = "webgpu")]
use effigy_render::webgpu;
use std::{error::Error, fmt};

/// An error of the command line itself, with what to do about it.
#[derive(Debug)]
pub struct Advised {
    fact: String,
    advice: &'static str,
}

impl Advised {
    pub fn new(fact: impl Into<String>, advice: &'static str) -> Self {
        Self {
            fact: fact.into(),
            advice,
        }
    }
}

impl fmt::Display for Advised {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.fact)
    }
}

impl Error for Advised {}

/// Advice on the first of an error and its causes for which there is any.
pub fn for_error(error: &anyhow::Error) -> Option<&'static str> {
    error.chain().find_map(for_cause)
}

fn for_cause(cause: &(dyn Error + 'static)) -> Option<&'static str> {
    if let Some(error) = cause.downcast_ref::<Advised>() {
        return Some(error.advice);
    }
    if let Some(error) = cause.downcast_ref::<vulkan::Error>() {
        return for_vulkan(error);
    }
    #[cfg(feature = "webgpu")]
    if let Some(error) = cause.downcast_ref::<webgpu::Error>() {
        return for_webgpu(error);
    }
    // A transparent error stands in the chain in place of the one that it holds.
    if let Some(error) = cause.downcast_ref::<BackendError>() {
        return match error {
            BackendError::Vulkan(error) => for_vulkan(error),
            #[cfg(feature = "webgpu")]
            BackendError::WebGpu(error) => for_webgpu(error),
        };
    }
    if let Some(bake::SourceError::Io { .. }) = cause.downcast_ref() {
        return Some(
            "`tools/fetch_assets.sh` gets the source files; --assets names the folder with them",
        );
    }
    None
}

const OTHER_DEVICE: &str =
    "`effigy devices` lists every device and what it can do; choose one with --device";
/// Advice where a driver can't draw triangles.
pub const NO_TRIANGLES: &str =
    "set LP_NATIVE_VECTOR_WIDTH=256, or use `--raster tiles-shared` and no window";
const SMALLER_AVATAR: &str =
    "use an avatar with fewer Gaussians or basis rows, or another device with --device";

fn for_vulkan(error: &vulkan::Error) -> Option<&'static str> {
    use vulkan::Error as E;
    match error {
        E::NoLoader(_) => Some(
            "install the driver of your GPU; for a CPU driver on Debian and Ubuntu, `apt-get install mesa-vulkan-drivers libvulkan1`",
        ),
        E::NoDevice => Some(
            "install the driver of your GPU; for a CPU driver on Debian and Ubuntu, `apt-get install mesa-vulkan-drivers`",
        ),
        E::NoSuchDevice { .. }
        | E::NoStatistics { .. }
        | E::Unsupported { .. }
        | E::NoWindow { .. } => Some(OTHER_DEVICE),
        E::NoTriangles { .. } => Some(NO_TRIANGLES),
        E::NoWindowExtension => {
            Some("install the driver of your GPU, or draw without a window: `effigy render`")
        }
        E::NoSort { .. } => Some(
            "`effigy devices` says how each variant of the sort did; to test them again, delete the \
             record that the error names",
        ),
        E::TooLarge { .. } => Some(SMALLER_AVATAR),
        E::ImageSize { .. } => Some("choose another size with --size"),
        E::NoValidation => Some("on Debian and Ubuntu, `apt-get install vulkan-validationlayers`"),
        E::OutOfMemory { .. } => Some("close other programs, or draw a smaller image or avatar"),
        _ => None,
    }
}

#[cfg(feature = "webgpu")]
fn for_webgpu(error: &webgpu::Error) -> Option<&'static str> {
    use webgpu::Error as E;
    match error {
        E::Unsupported { .. } => Some(NO_TRIANGLES),
        E::TooLarge { .. } => Some(SMALLER_AVATAR),
        E::ImageSize { .. } => Some("choose another size with --size"),
        E::Sort => Some("leave out --sort, or draw with --backend vulkan"),
        E::CooperativeTiles => Some("write --raster tiles-shared, or draw with --backend vulkan"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::Context;

    fn no_such_device() -> vulkan::Error {
        vulkan::Error::NoSuchDevice {
            wanted: "gpu".into(),
            found: "none".into(),
        }
    }

    #[test]
    fn advice_is_found_below_context_and_transparent_errors() {
        let wrapped: Result<(), _> = Err(no_such_device());
        let error = wrapped.context("bench failed").unwrap_err();
        assert_eq!(for_error(&error), Some(OTHER_DEVICE));
        let error = anyhow::Error::from(BackendError::Vulkan(no_such_device()));
        assert_eq!(for_error(&error), Some(OTHER_DEVICE));
    }

    #[test]
    fn errors_without_advice_get_none() {
        assert_eq!(for_error(&anyhow::anyhow!("a clip has no frames")), None);
        let lost = vulkan::Error::DeviceLost("vkQueueSubmit");
        assert_eq!(for_error(&lost.into()), None);
    }
}
