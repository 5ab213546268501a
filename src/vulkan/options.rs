//! What a renderer is made with: everything that trades time or memory for something else.

use super::{
    device::Gpu,
    raster::{ColorFormat, Method},
    sort::{KeyBits, Variant},
};
use crate::frame::{ALPHA_MIN, Skip};

/// What a renderer is made with.
#[derive(Clone, Copy, Debug)]
pub struct RendererOptions {
    /// Width and height of the picture, px.
    pub size: [u32; 2],
    /// What the picture is stored in. None: as suits the method, 8 bits where each pixel is rounded once.
    pub color: Option<ColorFormat>,
    /// How splats are drawn. None: as suits the device.
    pub method: Option<Method>,
    pub key_bits: KeyBits,
    /// How to sort. None: as the self-test finds best.
    pub sort: Option<Variant>,
    /// What is left out where the scene doesn't need it.
    pub skip: Skip,
    /// Contributions below this opacity are not drawn, at least 1/255 (model.md, step 10).
    pub cutoff: f64,
    /// How far behind the depth surface something is hidden, metres.
    pub margin: f64,
    /// Copies of the avatar that a scene may have, at least 1: memory grows with it.
    pub actors: usize,
    /// Count fragments, where the device can, and why Gaussians are left out: for measurements, since some devices are slower then.
    pub count: bool,
}

impl RendererOptions {
    /// The defaults at a size.
    pub fn new(size: [u32; 2]) -> Self {
        Self {
            size,
            color: None,
            method: None,
            key_bits: KeyBits::default(),
            sort: None,
            skip: Skip::all() - Skip::DEPTH,
            cutoff: ALPHA_MIN,
            margin: 0.005,
            actors: 1,
            count: false,
        }
    }

    /// The same with what suits a device in place of what was left open.
    pub fn settled(self, gpu: &Gpu) -> Self {
        let method = self.method.unwrap_or_else(|| Method::suited(gpu));
        Self { method: Some(method), color: Some(self.color.unwrap_or_else(|| method.color())), ..self }
    }
}
