//! The `raster` stage: splats in drawing order go in, a picture comes out (model.md, step 10). Two ways, as [`Method`] says.

use super::{
    buffer::{STORAGE, Slice, empty},
    device::Gpu,
    error::{Error, Result},
    kernel::{Bindings, Blocks, Bound, Kernel, module},
    owned::{Buffer, Owned, Texture},
    slot::Slot,
};
use crate::{
    frame::{
        ColorFormat, Method, RendererOptions, Skip, Touched,
        options::{NO_TRIANGLES, draws_triangles},
    },
    layout::{BINS_BLOCKS, BINS_SIZE, BINS_WEB, RASTER_QUADS, Settings},
    webgpu::shaders,
};
use wgpu::{BlendComponent, BlendFactor, BlendOperation, BlendState, ShaderStages, TextureFormat, TextureUsages};

/// What a picture's texture is made as.
pub fn texture(gpu: &Gpu, label: &'static str, [width, height]: [u32; 2], format: TextureFormat, usage: TextureUsages) -> Texture {
    Owned(gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    }))
}

fn wgpu_format(format: ColorFormat) -> TextureFormat {
    match format {
        ColorFormat::Rgba8 => TextureFormat::Rgba8Unorm,
        ColorFormat::Rgba16F => TextureFormat::Rgba16Float,
    }
}

/// Order, splats with their keys, and control as the stages before leave them.
#[derive(Clone, Copy)]
pub struct Inputs<'a> {
    pub order: Slice<'a>,
    pub splats: Slice<'a>,
    pub keys: Slice<'a>,
    pub control: &'a wgpu::Buffer,
    /// Splats at most.
    pub capacity: u32,
}

/// Draws by one of the methods.
enum Way {
    Hulls { bindings: Bindings, pipeline: wgpu::RenderPipeline, indices: Buffer },
    Tiles { bins: Kernel, raster: Box<Kernel>, buffer: Buffer },
}

pub struct Raster {
    way: Way,
    format: ColorFormat,
    image: Texture,
    view: wgpu::TextureView,
}

impl Raster {
    /// `options` with colour and method settled.
    pub fn new(gpu: &Gpu, blocks: &Blocks, inputs: Inputs, options: &RendererOptions) -> Result<Self> {
        let method = options.method.unwrap_or(Method::Hulls);
        let format = options.color.unwrap_or(method.color());
        let image = picture(gpu, format, options.size)?;
        let view = image.create_view(&Default::default());
        let way = match method {
            Method::Hulls => hulls(gpu, blocks, inputs, format)?,
            Method::Tiles => tiles(gpu, blocks, inputs, (format, &view))?,
        };
        Ok(Self { way, format, image, view })
    }

    /// Says what the shaders are told of the options.
    pub fn fill(settings: &mut Settings, options: &RendererOptions, capacity: u32) {
        settings.cutoff = options.cutoff as f32;
        settings.least = options.cutoff.log2() as f32;
        settings.hull = if options.skip.contains(Skip::FAINT) { settings.least } else { 0.0 };
        settings.full = if options.skip.contains(Skip::FULL) { settings.cutoff } else { 0.0 };
        settings.nodes = BINS_WEB.nodes(capacity)[0];
        settings.count = options.count.into();
    }

    /// The picture: premultiplied colour.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn image(&self) -> &wgpu::Texture {
        &self.image
    }

    pub fn view(&self) -> &wgpu::TextureView {
        &self.view
    }

    #[cfg(not(target_arch = "wasm32"))]
    pub fn format(&self) -> ColorFormat {
        self.format
    }

    /// Dispatches of a frame.
    pub fn dispatches(&self) -> u64 {
        match self.way {
            Way::Hulls { .. } => 0,
            Way::Tiles { .. } => 2,
        }
    }

    /// Changes the picture's size. On failure the old picture stays.
    pub fn resize(&mut self, gpu: &Gpu, blocks: &Blocks, inputs: Inputs, size: [u32; 2]) -> Result<()> {
        let image = picture(gpu, self.format, size)?;
        let view = image.create_view(&Default::default());
        if let Way::Tiles { raster, buffer, .. } = &mut self.way {
            raster.bindings.set(gpu, &tile_bindings(blocks, inputs, buffer, (self.format, &view)));
        }
        (self.image, self.view) = (image, view);
        Ok(())
    }

    /// Draws what the sort left: tiles every pixel that is to be drawn, quads every one. `frame` is a block with the picture's size.
    pub fn record(&self, slot: &mut Slot, encoder: &mut wgpu::CommandEncoder, frame: u32, (control, touched): (&wgpu::Buffer, &Touched)) {
        match &self.way {
            Way::Hulls { bindings, pipeline, indices } => {
                let writes = slot.stage("raster");
                let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                    label: Some("raster"),
                    color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                        view: &self.view,
                        depth_slice: None,
                        resolve_target: None,
                        ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT), store: wgpu::StoreOp::Store },
                    })],
                    timestamp_writes: slot.draw_writes(writes),
                    ..Default::default()
                });
                pass.set_pipeline(pipeline);
                bindings.bind_draw(&mut pass, frame);
                pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint16);
                pass.draw_indexed_indirect(control, 0);
            }
            Way::Tiles { bins: kernel, raster, buffer } => {
                encoder.clear_buffer(buffer, 0, Some(BINS_WEB.bytes(0)[0]));
                let writes = slot.stage("bins");
                kernel.dispatch(&mut slot.pass(encoder, "bins", writes), frame, [BINS_BLOCKS / BINS_SIZE, 1]);
                let writes = slot.stage("raster");
                let [first, end] = touched.regions();
                let groups = [end[0] - first[0], end[1] - first[1]];
                raster.dispatch(&mut slot.pass(encoder, "raster", writes), frame, groups);
            }
        }
    }
}

fn picture(gpu: &Gpu, format: ColorFormat, size: [u32; 2]) -> Result<Texture> {
    let limit = gpu.device.limits().max_texture_dimension_2d;
    if size.iter().any(|&side| side == 0 || side > limit) {
        let found = format!("{} × {}", size[0], size[1]);
        return Err(Error::PictureSize { found, limit, device: gpu.name().into() });
    }
    let all = [TextureUsages::RENDER_ATTACHMENT, TextureUsages::STORAGE_BINDING, TextureUsages::TEXTURE_BINDING, TextureUsages::COPY_SRC];
    let usage = all.into_iter().fold(TextureUsages::empty(), |all, one| all | one);
    Ok(texture(gpu, "target", size, wgpu_format(format), usage))
}

fn hulls(gpu: &Gpu, blocks: &Blocks, inputs: Inputs, format: ColorFormat) -> Result<Way> {
    let bound = [
        blocks.frame(),
        (1, Bound::Read(inputs.order)),
        (2, Bound::Read(inputs.splats)),
        (3, Bound::Read(inputs.control.into())),
        blocks.settings(),
    ];
    let bindings = Bindings::new(gpu, ShaderStages::VERTEX_FRAGMENT, &bound);
    let quad = |quad: u32| [0, 1, 2, 2, 1, 3].map(|corner| (4 * quad + corner) as u16);
    let indices: Vec<u16> = (0..RASTER_QUADS).flat_map(quad).collect();
    let indices = super::buffer::filled(gpu, "quad indices", bytemuck::cast_slice(&indices), wgpu::BufferUsages::INDEX)?;
    // "Over": C = αc + (1 − α) C, and coverage likewise, which leaves the picture premultiplied. The fragment's colour is not, so that a
    // blender that rounds uses one rounded alpha for both terms.
    let over = |src_factor| BlendComponent { src_factor, dst_factor: BlendFactor::OneMinusSrcAlpha, operation: BlendOperation::Add };
    let blend = Some(BlendState { color: over(BlendFactor::SrcAlpha), alpha: over(BlendFactor::One) });
    let target = wgpu::ColorTargetState { format: wgpu_format(format), blend, write_mask: wgpu::ColorWrites::ALL };
    let pipeline = draw_pipeline(gpu, "raster", (&bindings, &bound), [&shaders::RASTER_VERTEX, &shaders::RASTER_FRAGMENT], target)?;
    Ok(Way::Hulls { bindings, pipeline, indices })
}

/// A pipeline of triangles without depth.
///
/// # Errors
/// Where the driver would not survive drawing.
pub fn draw_pipeline(
    gpu: &Gpu,
    label: &'static str,
    (bindings, bound): (&Bindings, &[(u32, Bound)]),
    [vertex, fragment]: [&shaders::Module; 2],
    target: wgpu::ColorTargetState,
) -> Result<wgpu::RenderPipeline> {
    if !draws_triangles(gpu.name()) {
        return Err(Error::Lacks { device: gpu.name().into(), lacks: NO_TRIANGLES });
    }
    Ok(gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(label),
        layout: Some(&bindings.pipeline_layout(gpu)),
        vertex: wgpu::VertexState {
            module: &module(gpu, vertex, bound),
            entry_point: None,
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module(gpu, fragment, bound),
            entry_point: None,
            compilation_options: Default::default(),
            targets: &[Some(target)],
        }),
        multiview_mask: None,
        cache: None,
    }))
}

fn tiles(gpu: &Gpu, blocks: &Blocks, inputs: Inputs, picture: (ColorFormat, &wgpu::TextureView)) -> Result<Way> {
    let buffer = empty(gpu, "bins", BINS_WEB.bytes(inputs.capacity)[1], STORAGE)?;
    let bound = [
        blocks.frame(),
        (1, Bound::Read(inputs.order)),
        (2, Bound::Read(inputs.splats)),
        (3, Bound::Write(inputs.control.into())),
        (4, Bound::Write((&buffer).into())),
        blocks.settings(),
    ];
    let bins = Kernel::new(gpu, &shaders::BINS, &bound);
    let module = match picture.0 {
        ColorFormat::Rgba8 => &shaders::RASTER_RGBA8,
        ColorFormat::Rgba16F => &shaders::RASTER_RGBA16F,
    };
    let raster = Box::new(Kernel::new(gpu, module, &tile_bindings(blocks, inputs, &buffer, picture)));
    Ok(Way::Tiles { bins, raster, buffer })
}

fn tile_bindings<'a>(
    blocks: &'a Blocks,
    inputs: Inputs<'a>,
    buffer: &'a wgpu::Buffer,
    (format, view): (ColorFormat, &'a wgpu::TextureView),
) -> [(u32, Bound<'a>); 7] {
    [
        blocks.frame(),
        (1, Bound::Read(inputs.splats)),
        (2, Bound::Write(inputs.control.into())),
        (3, Bound::Read(buffer.into())),
        (4, Bound::Picture(view, wgpu_format(format))),
        (5, Bound::Read(inputs.keys)),
        blocks.settings(),
    ]
}
