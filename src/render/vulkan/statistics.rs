//! Statistics of a driver's compiler about every shader, on a device that is opened for them alone.
//!
//! Every pipeline asks the driver when it is made, so [`all`] has no list of shaders to keep, only
//! one of what can be made.

pub use super::device::statistics::{Executable, Statistic, StatisticValue};
use super::{
    device::{Error, Gpu, GpuOptions, Result},
    memory::Buffer,
    raster::{RasterMethod, resolve::Resolve},
    renderer::Renderer,
    sort::{KeyBits, Sort, SortOptions, SortVariant, unsupported},
    window::present::Present,
};
use ash::vk;
use effigy_core::{
    avatar::{Avatar, ShCoefficients},
    frame::{RendererOptions, Skip},
};
use gpu_allocator::MemoryLocation;
use half::f16;
use std::sync::Arc;

/// Statistics of a device's compiler about every pipeline that a [`Renderer`], a [`Sort`] or a
/// window can ask for. Nothing runs on the device.
///
/// # Errors
/// Where the driver does not tell ([`Error::NoStatistics`]), or can't make a pipeline.
pub fn all(options: &GpuOptions, avatar: &Avatar) -> Result<(Arc<Gpu>, Vec<Executable>)> {
    let gpu = Gpu::new(&GpuOptions {
        statistics: true,
        ..options.clone()
    })?;
    let Some(statistics) = &gpu.statistics else {
        return Err(Error::NoStatistics {
            device: gpu.probe.name.clone(),
        });
    };
    renderers(&gpu, avatar)?;
    sorts(&gpu)?;
    let found = statistics.take();
    Ok((gpu, found))
}

/// A renderer for every choice that leads to pipelines of its own.
fn renderers(gpu: &Arc<Gpu>, avatar: &Avatar) -> Result<()> {
    let any = SortVariant::ALL
        .into_iter()
        .find(|variant| unsupported(*variant, gpu).is_none());
    let options = RendererOptions {
        sort: any,
        ..RendererOptions::new([64, 64])
    };
    let resolve = |renderer: &Renderer| {
        let raster = renderer.raster();
        Resolve::new(gpu, raster.image(), raster.format())
    };
    for skip in [Skip::all(), Skip::empty()] {
        let quads = RendererOptions {
            skip,
            method: Some(RasterMethod::Quads),
            ..options
        };
        let renderer = Renderer::new(gpu, avatar, quads)?;
        resolve(&renderer)?;
        // As for a window, of which a device that was opened to be asked has none.
        let layout = vk::ImageLayout::TRANSFER_SRC_OPTIMAL;
        let mut present = Present::with_final_layout(gpu, vk::Format::B8G8R8A8_UNORM, layout)?;
        // SAFETY: nothing is recorded with it.
        unsafe { present.connect(renderer.raster()) }?;
    }
    // Not every device can run every kernel.
    let able = |method: &RasterMethod| gpu.probe.lacks_for(*method).is_none();
    let tiles = RasterMethod::ALL
        .into_iter()
        .filter(|method| method.is_tiles());
    for method in tiles.filter(able) {
        for exact in [false, true] {
            let tiles = RendererOptions {
                method: Some(method),
                exact,
                ..options
            };
            let renderer = Renderer::new(gpu, avatar, tiles)?;
            if !exact {
                resolve(&renderer)?;
            }
        }
    }
    let mut in_bytes = avatar.clone();
    for layer in &mut in_bytes.networks.layers {
        layer.weight = layer.weight.bytes(layer.input);
    }
    Renderer::new(gpu, &in_bytes, options)?;
    for degree in 1..=3 {
        let functions = (degree + 1) * (degree + 1) - 1;
        let coefficients = vec![[f16::ZERO; 3]; functions * avatar.gaussians.len()];
        let avatar = Avatar {
            sh: Some(ShCoefficients {
                degree,
                coefficients,
            }),
            ..avatar.clone()
        };
        Renderer::new(gpu, &avatar, options)?;
    }
    Ok(())
}

/// Every variant at every number of bits, of keys so few that each scatter sums the histograms
/// itself, and so many that kernels do.
fn sorts(gpu: &Arc<Gpu>) -> Result<()> {
    const COUNTS: [u32; 2] = [200_000, 1 << 21];
    let storage = |size| {
        Buffer::new(
            gpu,
            "keys",
            size,
            vk::BufferUsageFlags::STORAGE_BUFFER,
            MemoryLocation::GpuOnly,
        )
    };
    let control = storage(size_of::<effigy_core::layout::Control>() as u64)?;
    for count in COUNTS {
        let keys = storage(4 * u64::from(count))?;
        for variant in SortVariant::ALL
            .into_iter()
            .filter(|variant| unsupported(*variant, gpu).is_none())
        {
            for bits in [KeyBits::Sixteen, KeyBits::TwentyTwo, KeyBits::ThirtyTwo] {
                let options = SortOptions::new(bits, variant);
                // SAFETY: nothing is recorded with it.
                unsafe { Sort::new(gpu, (&keys).into(), &control, count, options) }?;
            }
        }
    }
    Ok(())
}
