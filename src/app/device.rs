//! Opens a device that can present to a window.

use ash::vk;
use effigy_render::vulkan::{
    Error, Gpu, GpuOptions, Result,
    swapchain::{NativeWindow, Surface},
};
use raw_window_handle::{HasDisplayHandle, HasWindowHandle};
use std::{sync::Arc, time::Instant};
use winit::window::Window;

/// A device that can present to a window.
pub struct WindowDevice {
    /// The window, as Vulkan needs it to create surfaces.
    pub target: NativeWindow,
    /// The window's surface.
    pub surface: Surface,
    /// The device.
    pub gpu: Arc<Gpu>,
}

/// Opens the device that `options` names. If it names none, the first that can present to the
/// window.
pub fn open(window: &Window, options: &GpuOptions) -> anyhow::Result<WindowDevice> {
    let began = Instant::now();
    // SAFETY: the painter, which holds all that is made of the target, holds the window too.
    let target = unsafe { NativeWindow::new(window.display_handle()?, window.window_handle()?) };
    match open_first(&target, options) {
        Ok(device) => {
            let took = began.elapsed().as_secs_f64() * 1e3;
            tracing::info!("opened the device in {took:.1} ms");
            Ok(device)
        }
        Err(error) if has_no_window_extension(&error) => Err(Error::NoWindowExtension.into()),
        Err(error) => Err(error.into()),
    }
}

fn open_first(target: &NativeWindow, options: &GpuOptions) -> Result<WindowDevice> {
    let options = GpuOptions {
        surface_extensions: target.extensions()?,
        ..options.clone()
    };
    let open_device = |device: Option<String>| {
        let gpu = Gpu::new(&GpuOptions {
            device,
            ..options.clone()
        })?;
        let surface = Surface::new(&gpu, target.clone())?;
        Ok(WindowDevice {
            target: target.clone(),
            surface,
            gpu,
        })
    };
    let refusal = match open_device(options.device.clone()) {
        Err(
            error
            @ (Error::Unsupported { .. } | Error::NoTriangles { .. } | Error::NoWindow { .. }),
        ) if options.device.is_none() => error,
        opened => return opened,
    };
    // The display may be connected to another device: try them all by their index.
    for index in 0u32.. {
        match open_device(Some(index.to_string())) {
            Ok(device) => return Ok(device),
            Err(Error::NoSuchDevice { .. } | Error::NoDevice) => break,
            Err(_) => {}
        }
    }
    Err(refusal)
}

/// Whether no driver on this machine has an extension that the window's surface needs.
fn has_no_window_extension(error: &Error) -> bool {
    matches!(
        error,
        Error::Call {
            call: "vkCreateInstance",
            code,
            ..
        } if *code == vk::Result::ERROR_EXTENSION_NOT_PRESENT.as_raw()
    )
}
