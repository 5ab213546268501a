//! Resolves a renderer's options for a device.

use super::choice::MethodChoice;
use crate::vulkan::device::gpu::Gpu;
use effigy_core::{
    frame::{RasterMethod, RendererOptions, Skip},
    scene::Supersampling,
};

/// How a renderer with these options draws on a device.
pub(crate) fn method(options: &RendererOptions, gpu: &Gpu) -> RasterMethod {
    let open = || MethodChoice::of(gpu).method;
    options.method.unwrap_or_else(open)
}

/// Options with every open choice made for a device, and without skips that it can't do.
pub fn resolved(gpu: &Gpu, options: RendererOptions) -> RendererOptions {
    drawn_by(gpu, options, method(&options, gpu))
}

/// [`resolved`], with the method already chosen.
pub(crate) fn drawn_by(
    gpu: &Gpu,
    options: RendererOptions,
    method: RasterMethod,
) -> RendererOptions {
    let mut skip = options.skip;
    let mut supersampling = options.supersampling;
    if !gpu.probe.draws_triangles() {
        skip -= Skip::DEPTH;
        supersampling = Supersampling::OFF;
    }
    // What the depth test saves costs more on CPU drivers (docs/experiments/038); who names quads
    // there wants to see it.
    if options.method.is_none() && gpu.probe.is_cpu() {
        skip -= Skip::DEPTH;
    }
    RendererOptions {
        method: Some(method),
        skip,
        supersampling,
        ..options
    }
}
