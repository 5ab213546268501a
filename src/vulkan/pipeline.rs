//! Compute kernels with their descriptor sets, and the parts that they share with the graphics pipelines.
//!
//! Every stage binds the same shape: at binding 0 the uniform block of the frame, at a dynamic offset since two frames are in flight,
//! and from binding 1 on storage buffers, at most four, as many as every device allows in a stage; an image may follow them.

use super::{
    device::Gpu,
    error::{During, Result},
    module::{ShaderModule, specialization_entries},
    shaders::Module,
};
use ash::vk;
use bytemuck::cast_slice;
use std::sync::Arc;

/// A part of a buffer that a shader sees.
#[derive(Clone, Copy)]
pub struct Slice {
    pub buffer: vk::Buffer,
    /// Bytes; a multiple of the device's storage buffer alignment, at most 256.
    pub offset: u64,
    /// Bytes.
    pub size: u64,
}

impl From<&super::memory::Buffer> for Slice {
    fn from(buffer: &super::memory::Buffer) -> Self {
        Self { buffer: buffer.raw, offset: 0, size: buffer.size }
    }
}

/// What a kernel does with its image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundImage {
    /// Reads a depth image through a sampler.
    Sampled,
    /// Writes texels.
    Written,
}

impl BoundImage {
    fn kind(self) -> vk::DescriptorType {
        match self {
            Self::Sampled => vk::DescriptorType::COMBINED_IMAGE_SAMPLER,
            Self::Written => vk::DescriptorType::STORAGE_IMAGE,
        }
    }

    /// The layout that the image is in while the kernel runs.
    pub fn layout(self) -> vk::ImageLayout {
        match self {
            Self::Sampled => vk::ImageLayout::DEPTH_STENCIL_READ_ONLY_OPTIMAL,
            Self::Written => vk::ImageLayout::GENERAL,
        }
    }
}

/// A descriptor set and the layouts that go with it.
pub struct Bindings {
    gpu: Arc<Gpu>,
    set_layout: vk::DescriptorSetLayout,
    pub layout: vk::PipelineLayout,
    pool: vk::DescriptorPool,
    pub set: vk::DescriptorSet,
    uniform: bool,
    /// Number of the image's binding, where there is one, and what it is.
    image: Option<(u32, BoundImage)>,
}

impl Bindings {
    /// `uniform` is the ring of frame blocks; sort kernels have none.
    pub fn new(gpu: &Arc<Gpu>, stages: vk::ShaderStageFlags, uniform: Option<Slice>, storage: &[Slice]) -> Result<Self> {
        Self::make(gpu, stages, uniform, storage, None)
    }

    /// The same for compute, and an image behind the buffers, which [`Kernel::set_image`] sets.
    pub fn with_image(gpu: &Arc<Gpu>, uniform: Option<Slice>, storage: &[Slice], image: BoundImage) -> Result<Self> {
        Self::make(gpu, vk::ShaderStageFlags::COMPUTE, uniform, storage, Some(image))
    }

    fn make(
        gpu: &Arc<Gpu>,
        stages: vk::ShaderStageFlags,
        uniform: Option<Slice>,
        storage: &[Slice],
        image: Option<BoundImage>,
    ) -> Result<Self> {
        let bind = |binding: usize, kind| {
            vk::DescriptorSetLayoutBinding::default().binding(binding as u32).descriptor_type(kind).descriptor_count(1).stage_flags(stages)
        };
        let (dynamic, plain) = (vk::DescriptorType::UNIFORM_BUFFER_DYNAMIC, vk::DescriptorType::STORAGE_BUFFER);
        let seen = image.unwrap_or(BoundImage::Sampled).kind();
        let mut bindings: Vec<_> = (1..=storage.len()).map(|binding| bind(binding, plain)).collect();
        bindings.extend(uniform.map(|_| bind(0, dynamic)));
        bindings.extend(image.map(|_| bind(storage.len() + 1, seen)));
        let mut new = Self {
            gpu: gpu.clone(),
            set_layout: Default::default(),
            layout: Default::default(),
            pool: Default::default(),
            set: Default::default(),
            uniform: uniform.is_some(),
            image: image.map(|image| (storage.len() as u32 + 1, image)),
        };
        let sizes = [(dynamic, 1), (seen, 1), (plain, storage.len().max(1) as u32)]
            .map(|(ty, descriptor_count)| vk::DescriptorPoolSize { ty, descriptor_count });
        // SAFETY: every structure outlives the call it is passed to; what was made before a failure is destroyed by `drop`.
        unsafe {
            let info = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
            new.set_layout = gpu.raw.create_descriptor_set_layout(&info, None).during("vkCreateDescriptorSetLayout")?;
            let layouts = [new.set_layout];
            let info = vk::PipelineLayoutCreateInfo::default().set_layouts(&layouts);
            new.layout = gpu.raw.create_pipeline_layout(&info, None).during("vkCreatePipelineLayout")?;
            let info = vk::DescriptorPoolCreateInfo::default().max_sets(1).pool_sizes(&sizes);
            new.pool = gpu.raw.create_descriptor_pool(&info, None).during("vkCreateDescriptorPool")?;
            let info = vk::DescriptorSetAllocateInfo::default().descriptor_pool(new.pool).set_layouts(&layouts);
            new.set = gpu.raw.allocate_descriptor_sets(&info).during("vkAllocateDescriptorSets")?[0];
        }
        new.write(uniform, storage);
        Ok(new)
    }

    /// Names all of it, for GPU profilers.
    pub fn label(&self, name: &str) {
        self.gpu.name(self.set_layout, name);
        self.gpu.name(self.layout, name);
        self.gpu.name(self.pool, name);
        self.gpu.name(self.set, name);
    }

    fn write(&self, uniform: Option<Slice>, storage: &[Slice]) {
        let info = |slice: &Slice| [vk::DescriptorBufferInfo { buffer: slice.buffer, offset: slice.offset, range: slice.size }];
        let plain = storage.iter().enumerate().map(|(at, slice)| (at as u32 + 1, vk::DescriptorType::STORAGE_BUFFER, info(slice)));
        let dynamic = uniform.iter().map(|slice| (0, vk::DescriptorType::UNIFORM_BUFFER_DYNAMIC, info(slice)));
        for (binding, kind, buffer) in plain.chain(dynamic) {
            let write = vk::WriteDescriptorSet::default().dst_set(self.set).dst_binding(binding).descriptor_type(kind).buffer_info(&buffer);
            // SAFETY: the set is not in use yet, the buffers are alive.
            unsafe { self.gpu.raw.update_descriptor_sets(&[write], &[]) };
        }
    }

    /// Binds the set; `offset` is where in the ring this frame's block is.
    pub fn bind(&self, commands: vk::CommandBuffer, point: vk::PipelineBindPoint, offset: u32) {
        let offsets: &[u32] = if self.uniform { &[offset] } else { &[] };
        // SAFETY: the command buffer is recording, the set is alive.
        unsafe { self.gpu.raw.cmd_bind_descriptor_sets(commands, point, self.layout, 0, &[self.set], offsets) };
    }
}

impl Drop for Bindings {
    fn drop(&mut self) {
        // SAFETY: owners drop bindings only when no submitted work uses them. Destroying null handles does nothing.
        self.gpu.destroy(|device| unsafe {
            device.destroy_descriptor_pool(self.pool, None);
            device.destroy_pipeline_layout(self.layout, None);
            device.destroy_descriptor_set_layout(self.set_layout, None);
        });
    }
}

/// What a kernel's pipeline is asked for besides its code.
#[derive(Clone, Copy, Default)]
pub struct Launch {
    /// Full subgroups of a size, which [`super::Probe::subgroup_sizes`] must hold; None leaves it to the driver.
    pub subgroup: Option<u32>,
    /// Whether a dispatch may start at another workgroup than the first: see [`Kernel::dispatch_within`].
    pub anywhere: bool,
}

/// A compute pipeline and what it binds.
pub struct Kernel {
    gpu: Arc<Gpu>,
    module: &'static Module,
    pipeline: vk::Pipeline,
    bindings: Bindings,
}

impl Kernel {
    /// `constants` are the specialization constants, 0 upwards; a module need not have all of them.
    pub fn new(gpu: &Arc<Gpu>, module: &'static Module, constants: &[u32], bindings: Bindings) -> Result<Self> {
        Self::with_launch(gpu, module, constants, bindings, Launch::default())
    }

    pub fn with_launch(gpu: &Arc<Gpu>, module: &'static Module, constants: &[u32], bindings: Bindings, launch: Launch) -> Result<Self> {
        bindings.label(module.file);
        let pipeline = compute_pipeline(gpu, module, constants, (bindings.layout, launch))?;
        Ok(Self { gpu: gpu.clone(), module, pipeline, bindings })
    }

    /// Gives it other constants. No submitted work may use it.
    pub fn specialize(&mut self, constants: &[u32], launch: Launch) -> Result<()> {
        let new = compute_pipeline(&self.gpu, self.module, constants, (self.bindings.layout, launch))?;
        let old = std::mem::replace(&mut self.pipeline, new);
        // SAFETY: the caller promises that no submitted work uses it.
        unsafe { self.gpu.raw.destroy_pipeline(old, None) };
        Ok(())
    }

    /// Sets the image of bindings that have one, in [`BoundImage::layout`]; a written one has no sampler. No submitted work may use the
    /// kernel.
    pub fn set_image(&self, sampler: vk::Sampler, image_view: vk::ImageView) {
        let Some((binding, bound)) = self.bindings.image else { return };
        let image = [vk::DescriptorImageInfo { sampler, image_view, image_layout: bound.layout() }];
        let write = vk::WriteDescriptorSet::default()
            .dst_set(self.bindings.set)
            .dst_binding(binding)
            .descriptor_type(bound.kind())
            .image_info(&image);
        // SAFETY: the caller promises that the set is not in use; view and sampler are alive.
        unsafe { self.gpu.raw.update_descriptor_sets(&[write], &[]) };
    }

    /// Runs `groups` workgroups; none for 0.
    pub fn dispatch(&self, commands: vk::CommandBuffer, offset: u32, groups: u32) {
        self.dispatch_2d(commands, offset, [groups, 1]);
    }

    /// The same in two dimensions.
    pub fn dispatch_2d(&self, commands: vk::CommandBuffer, offset: u32, [x, y]: [u32; 2]) {
        if x == 0 || y == 0 {
            return;
        }
        self.bind(commands, offset);
        // SAFETY: the command buffer is recording; pipeline and set are bound.
        unsafe { self.gpu.raw.cmd_dispatch(commands, x, y, 1) };
    }

    /// Runs the workgroups of a rectangle of a kernel that may start anywhere: its first column and row, and the first beyond it.
    pub fn dispatch_within(&self, commands: vk::CommandBuffer, offset: u32, [first, end]: [[u32; 2]; 2]) {
        let [x, y] = [0, 1].map(|axis| end[axis].saturating_sub(first[axis]));
        if x == 0 || y == 0 {
            return;
        }
        self.bind(commands, offset);
        // SAFETY: the command buffer is recording; pipeline and set are bound, and the pipeline may start at other workgroups than 0.
        unsafe { self.gpu.raw.cmd_dispatch_base(commands, first[0], first[1], 0, x, y, 1) };
    }

    fn bind(&self, commands: vk::CommandBuffer, offset: u32) {
        let point = vk::PipelineBindPoint::COMPUTE;
        self.bindings.bind(commands, point, offset);
        // SAFETY: the command buffer is recording; the pipeline is alive and matches the set's layout.
        unsafe { self.gpu.raw.cmd_bind_pipeline(commands, point, self.pipeline) };
    }
}

impl Drop for Kernel {
    fn drop(&mut self) {
        // SAFETY: owners drop a kernel only when no submitted work uses it.
        self.gpu.destroy(|device| unsafe { device.destroy_pipeline(self.pipeline, None) });
    }
}

/// The pipeline of a kernel.
fn compute_pipeline(
    gpu: &Gpu,
    module: &'static Module,
    constants: &[u32],
    (layout, launch): (vk::PipelineLayout, Launch),
) -> Result<vk::Pipeline> {
    let shader = ShaderModule::new(gpu, module)?;
    let entries = specialization_entries(constants);
    let specialization = vk::SpecializationInfo::default().map_entries(&entries).data(cast_slice(constants));
    let mut required =
        vk::PipelineShaderStageRequiredSubgroupSizeCreateInfo::default().required_subgroup_size(launch.subgroup.unwrap_or(0));
    let mut stage = vk::PipelineShaderStageCreateInfo::default()
        .stage(vk::ShaderStageFlags::COMPUTE)
        .module(shader.raw)
        .name(c"main")
        .specialization_info(&specialization);
    if launch.subgroup.is_some() {
        stage = stage.push_next(&mut required).flags(vk::PipelineShaderStageCreateFlags::REQUIRE_FULL_SUBGROUPS);
    }
    let anywhere = if launch.anywhere { vk::PipelineCreateFlags::DISPATCH_BASE } else { vk::PipelineCreateFlags::empty() };
    let info = vk::ComputePipelineCreateInfo::default().stage(stage).layout(layout).flags(gpu.pipeline_flags() | anywhere);
    let constants = constants.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
    tracing::debug!("compiling {} [{constants}]", module.file);
    // SAFETY: `info` and all it points to outlive the call.
    let created = unsafe { gpu.raw.create_compute_pipelines(gpu.cache.raw, &[info], None) };
    let pipeline = created.map_err(|(_, result)| result).during("vkCreateComputePipelines")?[0];
    gpu.made(pipeline, module.file, &[module], &constants)
}

/// What a barrier orders: all earlier work of some stages before all later work of others.
pub fn barrier(
    gpu: &Gpu,
    commands: vk::CommandBuffer,
    from: (vk::PipelineStageFlags, vk::AccessFlags),
    to: (vk::PipelineStageFlags, vk::AccessFlags),
) {
    let memory = vk::MemoryBarrier::default().src_access_mask(from.1).dst_access_mask(to.1);
    // SAFETY: the command buffer is recording.
    unsafe { gpu.raw.cmd_pipeline_barrier(commands, from.0, to.0, vk::DependencyFlags::empty(), &[memory], &[], &[]) };
}
