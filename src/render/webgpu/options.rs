//! Resolves a renderer's options for this backend and a device.

use super::{
    device::Gpu,
    error::{Error, Result},
    sort,
};
use crate::quirks::draws_triangles;
use effigy_core::{
    frame::{RasterMethod, RendererOptions, Skip, SortVariant, capacity::Capacity},
    scene::Supersampling,
};

/// Options with every open choice made for a device, and without skips that this backend or the
/// device can't do.
pub fn resolved(gpu: &Gpu, options: RendererOptions) -> RendererOptions {
    let draws_triangles = draws_triangles(gpu.name());
    // Most browsers do not say what class of GPU there is: quads suit phones, and are right on all.
    let method = options.method.unwrap_or(if draws_triangles {
        RasterMethod::Quads
    } else {
        RasterMethod::SharedTiles
    });
    // WebGPU's render passes draw the whole image.
    let whole = if method == RasterMethod::Quads {
        Skip::DAMAGE
    } else {
        Skip::empty()
    };
    // Nothing says whether the adapter is a CPU's, where the depth test costs more than it saves
    // (docs/experiments/038): who names quads wants to see it.
    let tested = if options.method.is_none() || !draws_triangles {
        Skip::DEPTH
    } else {
        Skip::empty()
    };
    let skip = options.skip - whole - tested;
    let sort = options.sort.unwrap_or(if gpu.is_cpu() {
        SortVariant::PerThread
    } else {
        SortVariant::ReduceThenScan
    });
    RendererOptions {
        method: Some(method),
        sort: Some(sort),
        supersampling: if draws_triangles {
            options.supersampling
        } else {
            Supersampling::OFF
        },
        skip,
        ..options
    }
}

/// Resolved options.
///
/// # Errors
/// When this backend can't draw with them.
pub fn accepted(gpu: &Gpu, options: RendererOptions) -> Result<RendererOptions> {
    options.check()?;
    if options.sort == Some(SortVariant::OneSweep) {
        return Err(Error::Sort);
    }
    if options.method == Some(RasterMethod::CooperativeTiles) {
        return Err(Error::CooperativeTiles);
    }
    Ok(resolved(gpu, options))
}

/// Checks the capacity of a renderer.
///
/// # Errors
/// When it is too large for the sort.
pub fn check_capacity(gpu: &Gpu, capacity: Capacity) -> Result<()> {
    let [found, limit] = [capacity.gaussians, sort::MAX_KEYS].map(|keys| 4 * u64::from(keys));
    if found > limit {
        return Err(Error::TooLarge {
            what: "sort keys",
            found,
            limit,
            device: gpu.name().into(),
        });
    }
    Ok(())
}
