//! Resolves a renderer's options for a device.

use crate::{quirks::recommended_method, vulkan::device::gpu::Gpu};
use effigy_core::{
    frame::{RasterMethod, RendererOptions, Skip, TileKernel},
    layout::PROJECT_WORKGROUP,
    scene::Supersampling,
};

/// How a renderer with these options draws on a device.
pub(crate) fn method(options: &RendererOptions, gpu: &Gpu) -> RasterMethod {
    options.method.unwrap_or_else(|| {
        recommended_method(gpu.probe.is_cpu(), &gpu.probe.name, &gpu.probe.driver)
    })
}

/// The kernel of the tile rasterizer with these options on a device. CPU drivers execute a few
/// invocations at a time: they have kernels of their own. Subgroups of 16 have not been timed.
pub(crate) fn tile_kernel(options: &RendererOptions, gpu: &Gpu) -> TileKernel {
    options.kernel.unwrap_or_else(|| {
        let preferred = if !gpu.probe.is_cpu() {
            TileKernel::Shared
        } else if gpu.probe.driver.starts_with("SwiftShader") {
            TileKernel::PerThread
        } else {
            TileKernel::Cooperative
        };
        match gpu.probe.lacks_for(preferred) {
            Some(_) => TileKernel::PerThread,
            None => preferred,
        }
    })
}

/// Options with every open choice made for a device, and without skips that it can't do.
pub fn resolved(gpu: &Gpu, options: RendererOptions) -> RendererOptions {
    let method = method(&options, gpu);
    let mut skip = options.skip;
    let mut supersampling = options.supersampling;
    if !gpu.probe.draws_triangles() {
        skip -= Skip::DEPTH;
        supersampling = Supersampling::OFF;
    }
    // Whether the depth test saves more than it costs is measured: on CPU drivers it does not
    // (docs/experiments/038).
    if options.method.is_none() {
        skip -= Skip::DEPTH;
    }
    RendererOptions {
        method: Some(method),
        kernel: Some(tile_kernel(&options, gpu)),
        key_bits: Some(options.keys()),
        workgroup: Some(options.workgroup.unwrap_or(PROJECT_WORKGROUP)),
        packed_words: Some(options.packed_words.unwrap_or(!gpu.half_storage)),
        color: Some(options.color.unwrap_or_else(|| method.color())),
        skip,
        supersampling,
        ..options
    }
}
