//! What a device makes of a renderer's options.

use super::{device::Gpu, raster::Method};
use crate::frame::{RendererOptions, Skip};

impl RendererOptions {
    /// How it draws on a device.
    pub(super) fn method_on(&self, gpu: &Gpu) -> Method {
        self.method.unwrap_or_else(|| Method::suited(gpu.probe.is_cpu(), &gpu.probe.name, &gpu.probe.driver))
    }

    /// The same with what suits a device in place of what was left open.
    pub fn settled(self, gpu: &Gpu) -> Self {
        let method = self.method_on(gpu);
        let skip = if gpu.probe.draws_triangles() { self.skip } else { self.skip - Skip::HIDDEN - Skip::DEPTH };
        Self { method: Some(method), color: Some(self.color.unwrap_or_else(|| method.color())), skip, ..self }
    }
}
