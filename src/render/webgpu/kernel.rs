//! Bindings and compute pipelines.

use super::{
    buffer::{Slice, empty},
    device::Gpu,
    error::Result,
    owned::Buffer,
};
use crate::wgsl::{IMAGE_FORMAT, WgslModule};
use bytemuck::bytes_of;
use effigy_core::layout::{Control, FrameBlock, SettingsBlock};
use std::sync::OnceLock;
use wgpu::{
    BindGroupEntry, BindGroupLayoutEntry, BindingResource, BindingType, BufferBinding,
    BufferBindingType, BufferUsages, ShaderStages, StorageTextureAccess, TextureFormat,
    TextureSampleType, TextureViewDimension,
};

/// Bytes from one avatar's uniform block to the next.
const FRAME_STRIDE: u64 = (size_of::<FrameBlock>() as u64).next_multiple_of(256);
const SETTINGS_SIZE: u64 = size_of::<SettingsBlock>() as u64;
const CONTROL_SIZE: u64 = size_of::<Control>() as u64;
/// Binding of the settings: `shaders/common/settings.glsl`.
const SETTINGS: u32 = 7;

/// A resource that a shader sees at a binding.
#[derive(Clone, Copy)]
pub enum Bound<'a> {
    /// Blocks of so many bytes, of which a dispatch or a draw names one by its offset.
    Block(&'a wgpu::Buffer, u64),
    Uniform(&'a wgpu::Buffer),
    Read(Slice<'a>),
    Write(Slice<'a>),
    Texture(&'a wgpu::TextureView),
    /// A texture of unsigned integers.
    Words(&'a wgpu::TextureView),
    /// An image that is written, and its format.
    FrameImage(&'a wgpu::TextureView, TextureFormat),
}

impl<'a> Bound<'a> {
    fn kind(self) -> BindingType {
        let buffer = |ty, dynamic| BindingType::Buffer {
            ty,
            has_dynamic_offset: dynamic,
            min_binding_size: None,
        };
        let texture = |sample_type| BindingType::Texture {
            sample_type,
            view_dimension: TextureViewDimension::D2,
            multisampled: false,
        };
        match self {
            Self::Block(..) => buffer(BufferBindingType::Uniform, true),
            Self::Uniform(_) => buffer(BufferBindingType::Uniform, false),
            Self::Read(_) => buffer(BufferBindingType::Storage { read_only: true }, false),
            Self::Write(_) => buffer(BufferBindingType::Storage { read_only: false }, false),
            Self::Texture(_) => texture(TextureSampleType::Float { filterable: false }),
            Self::Words(_) => texture(TextureSampleType::Uint),
            Self::FrameImage(_, format) => BindingType::StorageTexture {
                access: StorageTextureAccess::WriteOnly,
                format,
                view_dimension: TextureViewDimension::D2,
            },
        }
    }

    fn resource(self) -> BindingResource<'a> {
        let range = |buffer, offset, size| {
            BindingResource::Buffer(BufferBinding {
                buffer,
                offset,
                size: std::num::NonZero::new(size),
            })
        };
        match self {
            Self::Block(buffer, size) => range(buffer, 0, size),
            Self::Uniform(buffer) => buffer.as_entire_binding(),
            Self::Read(slice) | Self::Write(slice) => {
                range(slice.buffer, slice.offset, slice.size.next_multiple_of(4))
            }
            Self::Texture(view) | Self::Words(view) | Self::FrameImage(view, _) => {
                BindingResource::TextureView(view)
            }
        }
    }
}

/// Where an avatar's uniform block is, bytes.
pub fn block_offset(number: usize) -> u32 {
    (number as u64 * FRAME_STRIDE) as u32
}

/// The uniform buffers that the stages share.
pub struct Blocks {
    /// One [`FrameBlock`] an avatar, [`FRAME_STRIDE`] apart.
    pub frames: Buffer,
    /// One [`SettingsBlock`].
    pub settings: Buffer,
    /// Settings and control of a frame's second layer. What the queue writes, it writes before all
    /// that an encoder holds: between two layers these are copied.
    second: Buffer,
}

impl Blocks {
    /// For as many avatars.
    pub fn new(gpu: &Gpu, instances: usize) -> Result<Self> {
        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let copied = BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
        // One more for an image without avatars.
        let frames = (instances as u64 + 1) * FRAME_STRIDE;
        Ok(Self {
            frames: empty(gpu, "frames", frames, uniform)?,
            settings: empty(gpu, "settings", SETTINGS_SIZE, uniform)?,
            second: empty(gpu, "second layer", SETTINGS_SIZE + CONTROL_SIZE, copied)?,
        })
    }

    /// Writes what the second layer of the next frame gets.
    pub fn write_second(&self, gpu: &Gpu, settings: &SettingsBlock, control: &Control) {
        gpu.queue.write_buffer(&self.second, 0, bytes_of(settings));
        gpu.queue
            .write_buffer(&self.second, SETTINGS_SIZE, bytes_of(control));
    }

    /// Gives the second layer its settings.
    pub fn second_settings(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.copy_buffer_to_buffer(&self.second, 0, &self.settings, 0, SETTINGS_SIZE);
    }

    /// Gives the second layer its control.
    pub fn second_control(&self, encoder: &mut wgpu::CommandEncoder, control: &wgpu::Buffer) {
        encoder.copy_buffer_to_buffer(&self.second, SETTINGS_SIZE, control, 0, CONTROL_SIZE);
    }

    /// Binding 0: the ring of frame blocks.
    pub fn frame(&self) -> (u32, Bound<'_>) {
        (
            0,
            Bound::Block(&self.frames, size_of::<FrameBlock>() as u64),
        )
    }

    /// The binding of the settings block.
    pub fn settings(&self) -> (u32, Bound<'_>) {
        settings(&self.settings)
    }
}

/// The binding of a [`SettingsBlock`].
pub fn settings(buffer: &wgpu::Buffer) -> (u32, Bound<'_>) {
    (SETTINGS, Bound::Uniform(buffer))
}

/// The bind groups of a shader, for resources of the same kinds that take turns.
pub struct Bindings {
    pub layout: wgpu::BindGroupLayout,
    groups: Vec<wgpu::BindGroup>,
    /// Whether a dispatch or a draw names a block.
    is_named: bool,
}

impl Bindings {
    pub fn new(gpu: &Gpu, stages: ShaderStages, bound: &[(u32, Bound)]) -> Self {
        let entry = |&(binding, bound): &(u32, Bound)| BindGroupLayoutEntry {
            binding,
            visibility: stages,
            ty: bound.kind(),
            count: None,
        };
        let entries: Vec<_> = bound.iter().map(entry).collect();
        let layout = gpu
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: None,
                entries: &entries,
            });
        let group = group(gpu, &layout, bound);
        Self {
            layout,
            groups: vec![group],
            is_named: bound
                .iter()
                .any(|(_, bound)| matches!(bound, Bound::Block(..))),
        }
    }

    /// Binds other resources of these kinds. `turn`: instead of which; the next number adds them to
    /// those that take turns.
    pub fn set(&mut self, gpu: &Gpu, turn: usize, bound: &[(u32, Bound)]) {
        let group = group(gpu, &self.layout, bound);
        match self.groups.get_mut(turn) {
            Some(own) => *own = group,
            None => self.groups.push(group),
        }
    }

    pub fn pipeline_layout(&self, gpu: &Gpu) -> wgpu::PipelineLayout {
        let layouts = [Some(&self.layout)];
        gpu.device
            .create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: None,
                bind_group_layouts: &layouts,
                immediate_size: 0,
            })
    }

    pub fn bind_compute(&self, pass: &mut wgpu::ComputePass, turn: usize, block: u32) {
        let blocks = &[block][..usize::from(self.is_named)];
        pass.set_bind_group(0, &self.groups[turn], blocks);
    }

    pub fn bind_draw(&self, pass: &mut wgpu::RenderPass, block: u32) {
        let blocks = &[block][..usize::from(self.is_named)];
        pass.set_bind_group(0, &self.groups[0], blocks);
    }
}

fn group(gpu: &Gpu, layout: &wgpu::BindGroupLayout, bound: &[(u32, Bound)]) -> wgpu::BindGroup {
    let entries: Vec<_> = bound
        .iter()
        .map(|&(binding, bound)| BindGroupEntry {
            binding,
            resource: bound.resource(),
        })
        .collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout,
        entries: &entries,
    })
}

/// The source of a module, for what it is bound to.
fn source(module: &WgslModule, bound: &[(u32, Bound)]) -> String {
    let buffers = bound.iter().filter_map(|&(binding, bound)| match bound {
        Bound::Read(slice) | Bound::Write(slice) => Some((binding, slice.size.next_multiple_of(4))),
        _ => None,
    });
    let mut source = module.lengths(buffers) + module.wgsl;
    for (_, bound) in bound {
        if let Bound::FrameImage(_, TextureFormat::Rgba16Float) = bound {
            source = source.replace(IMAGE_FORMAT, "rgba16float");
        }
    }
    source
}

fn create_module(device: &wgpu::Device, name: &str, source: &str) -> wgpu::ShaderModule {
    let descriptor = wgpu::ShaderModuleDescriptor {
        label: Some(name),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    };
    // SAFETY: these are the shaders that the Vulkan backend runs without such checks. Indices stay
    // inside the buffers: `Renderer` lets `Avatar::check` see each avatar and `validate::frame` each
    // frame, and sizes the buffers for them; `source` tells the shaders these sizes. Browsers check
    // on their own.
    unsafe {
        device.create_shader_module_trusted(descriptor, wgpu::ShaderRuntimeChecks::unchecked())
    }
}

/// A module on a device, for what it is bound to.
pub fn module(gpu: &Gpu, module: &WgslModule, bound: &[(u32, Bound)]) -> wgpu::ShaderModule {
    create_module(&gpu.device, module.name, &source(module, bound))
}

/// A compute pipeline and what it is bound to.
pub struct Kernel {
    pipeline: OnceLock<wgpu::ComputePipeline>,
    bindings: Bindings,
    device: wgpu::Device,
    layout: wgpu::PipelineLayout,
    shader: &'static WgslModule,
    source: String,
    /// Ids and values of the module's specialization constants.
    constants: Vec<(&'static str, f64)>,
}

impl Kernel {
    pub fn new(gpu: &Gpu, shader: &'static WgslModule, bound: &[(u32, Bound)]) -> Self {
        Self::specialized(gpu, shader, bound, Vec::new())
    }

    /// `constants`: ids and values of the module's specialization constants.
    pub fn specialized(
        gpu: &Gpu,
        shader: &'static WgslModule,
        bound: &[(u32, Bound)],
        constants: Vec<(&'static str, f64)>,
    ) -> Self {
        let new = Self {
            constants,
            ..Self::when_needed(gpu, shader, bound)
        };
        new.pipeline();
        new
    }

    /// Compiled by the first dispatch: for what the first frame does without.
    pub fn when_needed(gpu: &Gpu, shader: &'static WgslModule, bound: &[(u32, Bound)]) -> Self {
        let bindings = Bindings::new(gpu, ShaderStages::COMPUTE, bound);
        Self {
            pipeline: OnceLock::new(),
            layout: bindings.pipeline_layout(gpu),
            bindings,
            device: gpu.device.clone(),
            shader,
            source: source(shader, bound),
            constants: Vec::new(),
        }
    }

    /// Binds other resources, as [`Bindings::set`]. Where their arrays have other lengths the next
    /// dispatch compiles it again: all that take turns must have the same.
    pub fn set(&mut self, gpu: &Gpu, turn: usize, bound: &[(u32, Bound)]) {
        self.bindings.set(gpu, turn, bound);
        let source = source(self.shader, bound);
        if source != self.source {
            self.source = source;
            self.pipeline = OnceLock::new();
        }
    }

    fn pipeline(&self) -> &wgpu::ComputePipeline {
        self.pipeline.get_or_init(|| {
            self.device
                .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                    label: Some(self.shader.name),
                    layout: Some(&self.layout),
                    module: &create_module(&self.device, self.shader.name, &self.source),
                    entry_point: None,
                    compilation_options: wgpu::PipelineCompilationOptions {
                        constants: &self.constants,
                        zero_initialize_workgroup_memory: false,
                    },
                    cache: None,
                })
        })
    }

    /// `block`: where in the frames' buffer the block is, bytes.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass, block: u32, groups: [u32; 2]) {
        self.dispatch_turn(pass, 0, block, groups);
    }

    /// Dispatches with the resources whose turn it is.
    pub fn dispatch_turn(
        &self,
        pass: &mut wgpu::ComputePass,
        turn: usize,
        block: u32,
        [x, y]: [u32; 2],
    ) {
        if x == 0 || y == 0 {
            return;
        }
        pass.set_pipeline(self.pipeline());
        self.bindings.bind_compute(pass, turn, block);
        pass.dispatch_workgroups(x, y, 1);
    }
}
