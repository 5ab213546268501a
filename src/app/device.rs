//! The device of a window: the one that is asked for, else the first that can show pictures in it.

use crate::vulkan::{
    Error, Gpu, GpuOptions, Result,
    swapchain::{Surface, Target},
};
use ash::vk;
use raw_window_handle::{HasDisplayHandle, HasWindowHandle};
use std::sync::Arc;
use winit::window::Window;

/// Opens the device that `options` names, else the first that can show pictures in the window.
pub(super) fn open(window: &Window, options: &GpuOptions) -> anyhow::Result<(Target, Surface, Arc<Gpu>)> {
    let target = Target::new(window.display_handle()?, window.window_handle()?);
    let (surface, gpu) = open_for(&target, options).map_err(|error| if lacks_extension(&error) { no_windows() } else { error })?;
    Ok((target, surface, gpu))
}

fn open_for(target: &Target, options: &GpuOptions) -> Result<(Surface, Arc<Gpu>)> {
    let options = GpuOptions { surface_extensions: target.extensions()?, ..options.clone() };
    let open = |device: Option<String>| {
        let gpu = Gpu::new(&GpuOptions { device, ..options.clone() })?;
        Ok((Surface::new(&gpu, target.clone())?, gpu))
    };
    match open(options.device.clone()) {
        // Another device may be the one that the display hangs on. Numbers end where there is no device.
        Err(error @ Error::Lacks { .. }) if options.device.is_none() => {
            let others = (0u32..).map(|number| open(Some(number.to_string())));
            let mut others = others.take_while(|other| !matches!(other, Err(Error::NoSuchDevice { .. } | Error::NoDevice)));
            others.find_map(Result::ok).ok_or(error)
        }
        first => first,
    }
}

/// No driver on this machine has an extension that the window's surface needs.
fn lacks_extension(error: &Error) -> bool {
    matches!(error, Error::Call { call: "vkCreateInstance", result: vk::Result::ERROR_EXTENSION_NOT_PRESENT })
}

fn no_windows() -> Error {
    Error::Lacks {
        device: "the Vulkan driver".into(),
        lacks: "it has no extension for windows of this display: install your GPU's driver, or use `effigy render`".into(),
    }
}
