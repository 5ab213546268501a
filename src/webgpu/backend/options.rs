//! What this backend and a device make of a renderer's options.

use super::{
    device::Gpu,
    error::{Error, Result},
    sort,
};
use crate::{
    avatar::Avatar,
    frame::{KeyBits, Method, RendererOptions, Skip, Variant, options::draws_triangles, scene},
};

/// The options with what suits a device, and this backend, in place of what was left open.
pub fn settled(gpu: &Gpu, options: RendererOptions) -> RendererOptions {
    let method = options.method.unwrap_or_else(|| Method::suited(gpu.is_cpu(), gpu.name(), &gpu.driver()));
    // Here fragments are not tested against the depth surface, and a pass that draws draws all of the picture.
    let whole = if method == Method::Hulls { Skip::AREA } else { Skip::empty() };
    let hidden = if draws_triangles(gpu.name()) { Skip::empty() } else { Skip::HIDDEN };
    let skip = options.skip - Skip::DEPTH - whole - hidden;
    let sort = options.sort.unwrap_or(if gpu.is_cpu() { Variant::LaneScan } else { Variant::SelfScan });
    RendererOptions { method: Some(method), color: Some(options.color.unwrap_or(method.color())), sort: Some(sort), skip, ..options }
}

/// Those options for an avatar, unless they can't be drawn with.
pub fn accepted(gpu: &Gpu, avatar: &Avatar, options: RendererOptions) -> Result<RendererOptions> {
    options.check()?;
    if options.key_bits != KeyBits::Sixteen {
        return Err(Error::KeyBits(8 * options.key_bits.passes()));
    }
    if options.sort == Some(Variant::OneSweep) {
        return Err(Error::Sort);
    }
    let keys = options.actors as u64 * u64::from(scene::slots(avatar.gaussians.len() as u32));
    if keys > u64::from(sort::MOST) {
        return Err(Error::TooLarge { what: "sort keys", found: 4 * keys, limit: 4 * u64::from(sort::MOST), device: gpu.name().into() });
    }
    let mut options = settled(gpu, options);
    // Where colours change with the view, nothing is kept.
    if avatar.harmonics.is_some() {
        options.skip -= Skip::SKINNING;
    }
    Ok(options)
}
