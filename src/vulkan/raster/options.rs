//! Resolves a renderer's options for a device.

use crate::{
    quirks::leaves_loops,
    vulkan::device::{gpu::Gpu, probe::Probe},
};
use ash::vk;
use effigy_core::{
    frame::{RasterMethod, RendererOptions, Skip},
    scene::Supersampling,
};

/// How a renderer with these options draws on a device.
pub(crate) fn method(options: &RendererOptions, gpu: &Gpu) -> RasterMethod {
    options.method.unwrap_or_else(|| class_method(&gpu.probe))
}

/// The method for the class of device that one is of; what it can't run gives way to another.
fn class_method(probe: &Probe) -> RasterMethod {
    use RasterMethod::{CooperativeTiles, Quads, SharedTiles};
    let preferred = if !probe.is_cpu() {
        if is_desktop(probe.kind, probe.vendor) {
            [SharedTiles, Quads, CooperativeTiles]
        } else {
            [Quads, SharedTiles, CooperativeTiles]
        }
    } else if leaves_loops(&probe.driver) {
        [Quads, CooperativeTiles, SharedTiles]
    } else {
        [CooperativeTiles, Quads, SharedTiles]
    };
    let can = |method: &RasterMethod| probe.lacks_for(*method).is_none();
    preferred.into_iter().find(can).unwrap_or(Quads)
}

/// Whether a GPU is no phone's: those blend in tile memory, and quads suit them. On an H200 quads
/// take ten times as long as tiles (docs/gpu). `vendor`: its PCI number.
fn is_desktop(kind: vk::PhysicalDeviceType, vendor: u32) -> bool {
    const AMD: u32 = 0x1002;
    const NVIDIA: u32 = 0x10de;
    const INTEL: u32 = 0x8086;
    kind == vk::PhysicalDeviceType::DISCRETE_GPU || [AMD, NVIDIA, INTEL].contains(&vendor)
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
        key_bits: Some(options.keys()),
        color: Some(options.color.unwrap_or_else(|| method.color())),
        skip,
        supersampling,
        ..options
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phones_alone_are_not_desktops() {
        use vk::PhysicalDeviceType as Kind;
        for (kind, vendor, expected) in [
            (Kind::DISCRETE_GPU, 0x10de, true),
            (Kind::DISCRETE_GPU, 0, true),
            (Kind::INTEGRATED_GPU, 0x8086, true),
            (Kind::VIRTUAL_GPU, 0x10de, true),
            // Adreno, Mali and Apple.
            (Kind::INTEGRATED_GPU, 0x5143, false),
            (Kind::INTEGRATED_GPU, 0x13b5, false),
            (Kind::INTEGRATED_GPU, 0x106b, false),
        ] {
            assert_eq!(is_desktop(kind, vendor), expected, "{kind:?} {vendor:#x}");
        }
    }
}
