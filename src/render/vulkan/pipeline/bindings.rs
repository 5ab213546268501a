//! Descriptor bindings of a stage.
//!
//! Every stage binds the same shape: at binding 0 the uniform block of the frame, at a dynamic
//! offset since two frames are in flight, and from binding 1 on storage buffers, at most four, as
//! many as every device allows in a stage; an image may follow them.

use super::set::Set;
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, kept_pipelines::Layouts, recording::Recording},
    memory::{Replacement, Slice},
};
use ash::vk;
use std::sync::Arc;

/// Use of a kernel's image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundImage {
    /// Fetches texels that a kernel wrote.
    Read,
    /// Writes texels.
    Written,
}

impl BoundImage {
    fn kind(self) -> vk::DescriptorType {
        match self {
            Self::Read => vk::DescriptorType::COMBINED_IMAGE_SAMPLER,
            Self::Written => vk::DescriptorType::STORAGE_IMAGE,
        }
    }
}

/// Resources that a shader is bound to.
#[derive(Clone, Copy, Default)]
pub struct Resources<'a> {
    /// The ring of frame blocks; sort kernels have none.
    pub uniform: Option<Slice>,
    /// At bindings 1 and up.
    pub storage: &'a [Slice],
    /// Follows the buffers; [`super::Kernel::set_image`] sets it.
    pub image: Option<BoundImage>,
}

/// A descriptor set and the layouts that go with it. The buffers must outlive the work that uses
/// it.
pub(crate) struct Bindings {
    gpu: Arc<Gpu>,
    set: Set,
    /// Whether there is a frame block.
    uniform: bool,
    /// The storage buffers, at bindings 1 and up.
    storage: Vec<Slice>,
    /// Number of the image's binding, where there is one, and what it is.
    image: Option<(u32, BoundImage)>,
}

const UNIFORM: vk::DescriptorType = vk::DescriptorType::UNIFORM_BUFFER_DYNAMIC;
const STORAGE: vk::DescriptorType = vk::DescriptorType::STORAGE_BUFFER;

impl Bindings {
    pub fn new(
        gpu: &Arc<Gpu>,
        name: &str,
        stages: vk::ShaderStageFlags,
        resources: Resources,
    ) -> Result<Self> {
        let Resources {
            uniform,
            storage,
            image,
        } = resources;
        let count = storage.len() as u32;
        let mut kinds: Vec<_> = (1..=count).map(|binding| (binding, STORAGE)).collect();
        if uniform.is_some() {
            kinds.push((0, UNIFORM));
        }
        if let Some(image) = image {
            kinds.push((count + 1, image.kind()));
        }
        let new = Self {
            gpu: gpu.clone(),
            set: Set::new(gpu, name, stages, &kinds, 0)?,
            uniform: uniform.is_some(),
            storage: storage.to_vec(),
            image: image.map(|image| (count + 1, image)),
        };
        if let Some(uniform) = uniform {
            new.set_buffer(0, UNIFORM, uniform);
        }
        for (binding, &slice) in (1..).zip(storage) {
            new.set_buffer(binding, STORAGE, slice);
        }
        Ok(new)
    }

    /// The layout of pipelines that use the set.
    pub fn layout(&self) -> vk::PipelineLayout {
        self.set.layouts.pipeline.raw()
    }

    /// The layouts, for who keeps them.
    pub fn layouts(&self) -> &Arc<Layouts> {
        &self.set.layouts
    }

    /// What decides the layout of a stage's bindings: see [`PipelineKey`].
    ///
    /// [`PipelineKey`]: crate::vulkan::device::kept_pipelines::PipelineKey
    pub fn shape(&self) -> [u32; 3] {
        let image = self.image.map_or(u32::MAX, |(_, image)| image as u32);
        [u32::from(self.uniform), self.storage.len() as u32, image]
    }

    /// Binds the one buffer wherever the other was bound.
    ///
    /// # Safety
    /// No submitted work may use the set, and the new buffer must outlive what will.
    pub unsafe fn replace(&mut self, replacement: Replacement) {
        for at in 0..self.storage.len() {
            if let Some(new) = replacement.of(self.storage[at]) {
                self.storage[at] = new;
                self.set_buffer(at as u32 + 1, STORAGE, new);
            }
        }
    }

    /// The set must not be in use.
    fn set_buffer(&self, binding: u32, kind: vk::DescriptorType, slice: Slice) {
        let info = [vk::DescriptorBufferInfo {
            buffer: slice.buffer,
            offset: slice.offset,
            range: slice.size,
        }];
        let write = vk::WriteDescriptorSet::default()
            .dst_set(self.set.raw)
            .dst_binding(binding)
            .descriptor_type(kind)
            .buffer_info(&info);
        // SAFETY: the set is not in use, and the buffer alive.
        unsafe { self.gpu.raw.update_descriptor_sets(&[write], &[]) };
    }

    /// Sets the image of bindings that have one.
    ///
    /// # Safety
    /// No submitted work may use the set. The image must be in the layout `GENERAL` when it is
    /// used, and it and the sampler, which a written image has none of, must outlive that.
    pub unsafe fn set_image(&self, sampler: vk::Sampler, image_view: vk::ImageView) {
        let Some((binding, bound)) = self.image else {
            return;
        };
        let image = [vk::DescriptorImageInfo {
            sampler,
            image_view,
            image_layout: vk::ImageLayout::GENERAL,
        }];
        let write = vk::WriteDescriptorSet::default()
            .dst_set(self.set.raw)
            .dst_binding(binding)
            .descriptor_type(bound.kind())
            .image_info(&image);
        // SAFETY: the caller promises that the set is not in use, and that view and sampler are
        // alive.
        unsafe { self.gpu.raw.update_descriptor_sets(&[write], &[]) };
    }

    /// Binds the set. `offset`: where in the ring this frame's block is, bytes.
    pub fn bind(&self, commands: Recording, point: vk::PipelineBindPoint, offset: u32) {
        let offsets: &[u32] = if self.uniform { &[offset] } else { &[] };
        // SAFETY: the command buffer is recording, the set is alive and fits its layout.
        unsafe {
            self.gpu.raw.cmd_bind_descriptor_sets(
                commands.raw(),
                point,
                self.layout(),
                0,
                &[self.set.raw],
                offsets,
            )
        };
    }
}
