//! Resolves a renderer's options for a device.

use crate::{quirks::recommended_method, vulkan::device::gpu::Gpu};
use effigy_core::frame::{RasterMethod, RendererOptions, Skip};

/// How a renderer with these options draws on a device.
pub(crate) fn method(options: &RendererOptions, gpu: &Gpu) -> RasterMethod {
    options.method.unwrap_or_else(|| {
        recommended_method(gpu.probe.is_cpu(), &gpu.probe.name, &gpu.probe.driver)
    })
}

/// Options with every open choice made for a device, and without skips that it can't do.
pub fn resolved(gpu: &Gpu, options: RendererOptions) -> RendererOptions {
    let method = method(&options, gpu);
    let skip = if gpu.probe.draws_triangles() {
        options.skip
    } else {
        options.skip - Skip::HIDDEN - Skip::DEPTH
    };
    RendererOptions {
        method: Some(method),
        color: Some(options.color.unwrap_or_else(|| method.color())),
        skip,
        ..options
    }
}
