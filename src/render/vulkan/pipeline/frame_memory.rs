//! Where the resources of a frame's kernels are on the device.

use super::{BoundImage, Resources};
use crate::vulkan::memory::{Replacement, Slice};
use effigy_core::frame::{kernels::KernelSpec, resource::Resource};

/// The frame blocks, and the resources that are known so far.
#[derive(Clone, Copy)]
pub(crate) struct FrameMemory {
    frame: Slice,
    slices: [Option<Slice>; Resource::ALL.len()],
}

impl FrameMemory {
    /// `frame`: the ring of frame blocks.
    pub fn new(frame: Slice) -> Self {
        Self {
            frame,
            slices: [None; Resource::ALL.len()],
        }
    }

    /// These, and a resource. Of several that are parts of one buffer the first that kernels name
    /// stands for it.
    pub fn with(mut self, resource: Resource, slice: impl Into<Slice>) -> Self {
        self.slices[resource as usize] = Some(slice.into());
        self
    }

    /// Puts the one buffer wherever the other was.
    pub fn replace(&mut self, replacement: Replacement) {
        for slice in self.slices.iter_mut().flatten() {
            replacement.apply(slice);
        }
    }

    /// Where a resource is, which must be known.
    pub fn slice(&self, resource: Resource) -> Slice {
        self.slices[resource as usize].unwrap_or_else(|| panic!("{resource:?} is nowhere yet"))
    }

    /// Hands on what a kernel binds, as its row says.
    pub fn bound<T>(&self, kernel: &KernelSpec, bind: impl FnOnce(Resources) -> T) -> T {
        let mut rows = kernel.bindings.to_vec();
        rows.dedup_by_key(|binding| binding.number);
        let image = rows.pop_if(|binding| binding.resource.is_image());
        let storage: Vec<Slice> = rows
            .iter()
            .map(|binding| self.slice(binding.resource))
            .collect();
        bind(Resources {
            uniform: Some(self.frame),
            storage: &storage,
            image: image.map(|_| BoundImage::Written),
        })
    }
}
