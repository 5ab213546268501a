//! Compute kernels with their descriptor sets.

use super::{
    FrameMemory,
    bindings::{Bindings, Resources},
    module::{flags, list, shader_module, specialization_entries, take_over},
    shaders::Module,
};
use crate::vulkan::{
    device::{
        error::{During, Result},
        gpu::Gpu,
        handle::Pipeline,
        kept_pipelines::{PipelineKey, SharedPipeline},
        recording::Recording,
    },
    memory::Replacement,
};
use ash::vk;
use bytemuck::cast_slice;
use effigy_core::frame::kernels::KernelSpec;
use std::sync::Arc;

/// What a kernel's pipeline is asked for besides its code.
#[derive(Clone, Copy, Default)]
pub struct Launch {
    /// Full subgroups of a size, which `Probe::subgroup_sizes` must hold; None leaves it to the
    /// driver.
    pub subgroup: Option<u32>,
    /// Whether a dispatch may start at another workgroup than the first: see
    /// [`Kernel::dispatch_within`].
    pub anywhere: bool,
}

/// A compute pipeline and what it binds.
pub struct Kernel {
    gpu: Arc<Gpu>,
    module: &'static Module,
    pipeline: Arc<SharedPipeline>,
    bindings: Bindings,
}

impl Kernel {
    /// `constants` are the specialization constants, 0 upwards; a module need not have all of them.
    /// What `resources` holds must outlive the work that runs the kernel.
    pub fn new(
        gpu: &Arc<Gpu>,
        module: &'static Module,
        constants: &[u32],
        resources: Resources,
        launch: Launch,
    ) -> Result<Self> {
        let stages = vk::ShaderStageFlags::COMPUTE;
        let bindings = Bindings::new(gpu, module.file, stages, resources)?;
        let pipeline = compute_pipeline(gpu, module, constants, &bindings, launch)?;
        Ok(Self {
            gpu: gpu.clone(),
            module,
            pipeline,
            bindings,
        })
    }

    /// A kernel of a frame: it binds what its row says. `module`: one of the row's.
    pub(crate) fn of_frame(
        gpu: &Arc<Gpu>,
        spec: &KernelSpec,
        module: &'static Module,
        constants: &[u32],
        memory: &FrameMemory,
        launch: Launch,
    ) -> Result<Self> {
        debug_assert!(spec.modules.contains(&module.file));
        memory.bound(spec, |resources| {
            Self::new(gpu, module, constants, resources, launch)
        })
    }

    /// Gives it other constants. On failure it keeps those that it has.
    ///
    /// # Safety
    /// No submitted work may use the kernel.
    pub unsafe fn specialize(&mut self, constants: &[u32], launch: Launch) -> Result<()> {
        self.pipeline =
            compute_pipeline(&self.gpu, self.module, constants, &self.bindings, launch)?;
        Ok(())
    }

    /// Sets the image of a kernel that writes one.
    ///
    /// # Safety
    /// No submitted work may use the kernel. The image must be in the layout `GENERAL` when the
    /// kernel runs, and outlive that.
    pub unsafe fn set_image(&self, image_view: vk::ImageView) {
        // SAFETY: the caller promises what the function asks for.
        unsafe { self.bindings.set_image(vk::Sampler::null(), image_view) };
    }

    /// Binds the one buffer wherever the other was bound.
    ///
    /// # Safety
    /// No submitted work may use the kernel, and the new buffer must outlive what will.
    pub(crate) unsafe fn replace(&mut self, replacement: Replacement) {
        // SAFETY: the caller promises what the function asks for.
        unsafe { self.bindings.replace(replacement) };
    }

    /// Runs `groups` workgroups; none for 0. `offset`: where in the ring the frame's block is,
    /// bytes.
    pub fn dispatch(&self, commands: Recording, offset: u32, groups: u32) {
        self.dispatch_2d(commands, offset, [groups, 1]);
    }

    /// Runs a rectangle of workgroups, columns and rows; none where either is 0.
    pub fn dispatch_2d(&self, commands: Recording, offset: u32, groups: [u32; 2]) {
        let [x, y] = groups;
        if x == 0 || y == 0 {
            return;
        }
        self.bind(commands, offset);
        // SAFETY: the command buffer is recording; pipeline and set are bound.
        unsafe { self.gpu.raw.cmd_dispatch(commands.raw(), x, y, 1) };
    }

    /// Runs the workgroups of a rectangle of a kernel that may start anywhere: from the first
    /// column and row up to those beyond its end.
    pub fn dispatch_within(
        &self,
        commands: Recording,
        offset: u32,
        first: [u32; 2],
        end: [u32; 2],
    ) {
        let [x, y] = [0, 1].map(|axis| end[axis].saturating_sub(first[axis]));
        if x == 0 || y == 0 {
            return;
        }
        self.bind(commands, offset);
        // SAFETY: the command buffer is recording; pipeline and set are bound, and the pipeline may
        // start at other workgroups than 0.
        unsafe {
            self.gpu
                .raw
                .cmd_dispatch_base(commands.raw(), first[0], first[1], 0, x, y, 1)
        };
    }

    fn bind(&self, commands: Recording, offset: u32) {
        let point = vk::PipelineBindPoint::COMPUTE;
        self.bindings.bind(commands, point, offset);
        // SAFETY: the command buffer is recording; the pipeline is alive and matches the set's
        // layout.
        unsafe {
            self.gpu
                .raw
                .cmd_bind_pipeline(commands.raw(), point, self.pipeline.pipeline.raw())
        };
    }
}

/// The pipeline of a kernel: one that is kept, or a new one.
fn compute_pipeline(
    gpu: &Arc<Gpu>,
    module: &'static Module,
    constants: &[u32],
    bindings: &Bindings,
    launch: Launch,
) -> Result<Arc<SharedPipeline>> {
    let key = PipelineKey {
        module: module.file,
        constants: constants.to_vec(),
        subgroup: launch.subgroup,
        anywhere: launch.anywhere,
        bindings: bindings.shape(),
    };
    if let Some(kept) = gpu.kept_pipelines.get(&key) {
        return Ok(kept);
    }
    let new = Arc::new(SharedPipeline {
        pipeline: new_pipeline(gpu, module, constants, bindings.layout(), launch)?,
        _layouts: bindings.layouts().clone(),
    });
    gpu.kept_pipelines.put(key, &new);
    Ok(new)
}

fn new_pipeline(
    gpu: &Arc<Gpu>,
    module: &Module,
    constants: &[u32],
    layout: vk::PipelineLayout,
    launch: Launch,
) -> Result<Pipeline> {
    let shader = shader_module(gpu, module)?;
    let entries = specialization_entries(constants);
    let specialization = vk::SpecializationInfo::default()
        .map_entries(&entries)
        .data(cast_slice(constants));
    let mut required = vk::PipelineShaderStageRequiredSubgroupSizeCreateInfo::default()
        .required_subgroup_size(launch.subgroup.unwrap_or(0));
    let mut stage = vk::PipelineShaderStageCreateInfo::default()
        .stage(vk::ShaderStageFlags::COMPUTE)
        .module(shader.raw())
        .name(c"main")
        .specialization_info(&specialization);
    if launch.subgroup.is_some() {
        stage = stage
            .push_next(&mut required)
            .flags(vk::PipelineShaderStageCreateFlags::REQUIRE_FULL_SUBGROUPS);
    }
    let anywhere = if launch.anywhere {
        vk::PipelineCreateFlags::DISPATCH_BASE
    } else {
        vk::PipelineCreateFlags::empty()
    };
    let info = vk::ComputePipelineCreateInfo::default()
        .stage(stage)
        .layout(layout)
        .flags(flags(gpu) | anywhere);
    let constants = list(constants);
    tracing::debug!("compiling {} [{constants}]", module.file);
    // SAFETY: `info` and all it points to outlive the call; the pipeline is new.
    unsafe {
        let created = gpu
            .raw
            .create_compute_pipelines(gpu.cache.raw(), &[info], None);
        let pipeline = created
            .map_err(|(_, result)| result)
            .during("vkCreateComputePipelines")?[0];
        take_over(gpu, pipeline, module.file, &[module], &constants)
    }
}
