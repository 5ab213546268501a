//! The `raster` stage: splats in drawing order go in, an image comes out (model.md, step 10). Two
//! ways, as [`RasterMethod`] says.

use super::{
    buffer::{STORAGE, Slice, empty},
    device::Gpu,
    error::{Error, Result},
    frame_in_flight::{FrameInFlight, Writes},
    kernel::{Bindings, Blocks, Bound, Kernel, module},
    owned::{Buffer, Owned, Texture},
};
use crate::{
    quirks::{NO_TRIANGLES, draws_triangles},
    wgsl,
};
use effigy_core::{
    frame::{ColorFormat, Damage, RasterMethod, RendererOptions, Skip, Stage},
    layout::{
        BINNING_RUNS, BINNING_WORKGROUP, QUADS_PER_INSTANCE, RASTER_REGION, SettingsBlock,
        TILING_WEB,
    },
};
use wgpu::{
    BlendComponent, BlendFactor, BlendOperation, BlendState, ShaderStages, TextureFormat,
    TextureUsages,
};

/// Makes a texture of one level and one sample.
pub fn texture(
    gpu: &Gpu,
    label: &'static str,
    [width, height]: [u32; 2],
    format: TextureFormat,
    usage: TextureUsages,
) -> Texture {
    Owned(gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
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
pub struct RasterInputs<'a> {
    /// Indices of splats in drawing order.
    pub order: Slice<'a>,
    /// Splats, one a Gaussian.
    pub splats: Slice<'a>,
    /// A depth key for each splat.
    pub keys: Slice<'a>,
    /// Holds the number of visible splats, and the arguments of the draw.
    pub control: &'a wgpu::Buffer,
    /// The most splats that the buffers hold.
    pub capacity: u32,
}

/// One way to draw, as [`RasterMethod`] says.
pub enum Way {
    Quads {
        bindings: Bindings,
        pipeline: wgpu::RenderPipeline,
        indices: Buffer,
    },
    Tiles {
        binning: Kernel,
        raster: Box<Kernel>,
        lists: Buffer,
    },
}

pub struct Raster {
    way: Way,
    format: ColorFormat,
    image: Texture,
    view: wgpu::TextureView,
}

impl Raster {
    /// `options` with colour and method resolved.
    pub fn new(
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        options: &RendererOptions,
    ) -> Result<Self> {
        let method = options.method.unwrap_or(RasterMethod::Quads);
        let format = options.color.unwrap_or(method.color());
        let image = create_image(gpu, format, options.size)?;
        let view = image.create_view(&Default::default());
        let way = match method {
            RasterMethod::Quads => quads(gpu, blocks, inputs, format)?,
            RasterMethod::Tiles => tiles(gpu, blocks, inputs, format, &view)?,
        };
        Ok(Self {
            way,
            format,
            image,
            view,
        })
    }

    /// Writes the options that the shaders read to the settings block.
    pub fn fill(settings: &mut SettingsBlock, options: &RendererOptions, capacity: u32) {
        settings.cutoff = options.cutoff as f32;
        settings.cutoff_exponent = options.cutoff.log2() as f32;
        settings.quad_exponent = if options.skip.contains(Skip::FAINT) {
            settings.cutoff_exponent
        } else {
            0.0
        };
        settings.saturation = if options.skip.contains(Skip::SATURATED) {
            settings.cutoff
        } else {
            0.0
        };
        settings.blocks = TILING_WEB.blocks(capacity)[0];
        settings.counted = options.count.into();
    }

    /// The image: premultiplied colour.
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
            Way::Quads { .. } => 0,
            Way::Tiles { .. } => 2,
        }
    }

    /// Changes the image's size. On failure the old image stays.
    pub fn resize(
        &mut self,
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        size: [u32; 2],
    ) -> Result<()> {
        let image = create_image(gpu, self.format, size)?;
        let view = image.create_view(&Default::default());
        if let Way::Tiles { raster, lists, .. } = &mut self.way {
            raster.bindings.set(
                gpu,
                &tile_bindings(blocks, inputs, lists, self.format, &view),
            );
        }
        self.image = image;
        self.view = view;
        Ok(())
    }

    /// How it draws, with what that takes.
    pub fn way(&self) -> &Way {
        &self.way
    }

    /// Blends every quad into the cleared image. `block`: where a uniform block with the image's
    /// size is, bytes. `control` holds the arguments of the draw. `writes`: its
    /// timestamps.
    pub fn record_quads(
        &self,
        in_flight: &FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        block: u32,
        control: &wgpu::Buffer,
        writes: Writes,
    ) {
        let Way::Quads {
            bindings,
            pipeline,
            indices,
        } = &self.way
        else {
            return;
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(Stage::Raster.name()),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            timestamp_writes: in_flight.draw_writes(writes),
            ..Default::default()
        });
        pass.set_pipeline(pipeline);
        bindings.bind_draw(&mut pass, block);
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint16);
        pass.draw_indexed_indirect(control, 0);
    }
}

impl Way {
    /// Which of them it is.
    pub fn method(&self) -> RasterMethod {
        match self {
            Self::Quads { .. } => RasterMethod::Quads,
            Self::Tiles { .. } => RasterMethod::Tiles,
        }
    }

    /// Empties the tiles' lists.
    pub fn clear_tile_lists(&self, encoder: &mut wgpu::CommandEncoder) {
        if let Self::Tiles { lists, .. } = self {
            encoder.clear_buffer(lists, 0, Some(TILING_WEB.bytes(0)[0]));
        }
    }

    /// Writes splats to the lists of the tiles that they meet.
    pub fn record_binning(&self, pass: &mut wgpu::ComputePass, block: u32) {
        if let Self::Tiles { binning, .. } = self {
            binning.dispatch(pass, block, [BINNING_RUNS / BINNING_WORKGROUP, 1]);
        }
    }

    /// Blends the lists of the tiles in the damage rectangle.
    pub fn record_tiles(&self, pass: &mut wgpu::ComputePass, block: u32, damage: &Damage) {
        if let Self::Tiles { raster, .. } = self {
            let [first, end] = damage.regions(RASTER_REGION);
            raster.dispatch(pass, block, [end[0] - first[0], end[1] - first[1]]);
        }
    }
}

fn create_image(gpu: &Gpu, format: ColorFormat, size: [u32; 2]) -> Result<Texture> {
    let limit = gpu.device.limits().max_texture_dimension_2d;
    if size.iter().any(|&side| side == 0 || side > limit) {
        let found = format!("{} × {}", size[0], size[1]);
        return Err(Error::ImageSize {
            found,
            limit,
            device: gpu.name().into(),
        });
    }
    let all = [
        TextureUsages::RENDER_ATTACHMENT,
        TextureUsages::STORAGE_BINDING,
        TextureUsages::TEXTURE_BINDING,
        TextureUsages::COPY_SRC,
    ];
    let usage = all
        .into_iter()
        .fold(TextureUsages::empty(), |all, one| all | one);
    Ok(texture(gpu, "target", size, wgpu_format(format), usage))
}

fn quads(gpu: &Gpu, blocks: &Blocks, inputs: RasterInputs, format: ColorFormat) -> Result<Way> {
    let bound = [
        blocks.frame(),
        (1, Bound::Read(inputs.order)),
        (2, Bound::Read(inputs.splats)),
        (3, Bound::Read(inputs.control.into())),
        blocks.settings(),
    ];
    let bindings = Bindings::new(gpu, ShaderStages::VERTEX_FRAGMENT, &bound);
    let quad = |quad: u32| [0, 1, 2, 2, 1, 3].map(|corner| (4 * quad + corner) as u16);
    let indices: Vec<u16> = (0..QUADS_PER_INSTANCE).flat_map(quad).collect();
    let indices = super::buffer::filled(
        gpu,
        "quad indices",
        bytemuck::cast_slice(&indices),
        wgpu::BufferUsages::INDEX,
    )?;
    // "Over": C = αc + (1 − α) C, and coverage likewise, which leaves the image premultiplied. The
    // fragment's colour is not, so that a blender that rounds uses one rounded alpha for both
    // terms.
    let over = |src_factor| BlendComponent {
        src_factor,
        dst_factor: BlendFactor::OneMinusSrcAlpha,
        operation: BlendOperation::Add,
    };
    let blend = Some(BlendState {
        color: over(BlendFactor::SrcAlpha),
        alpha: over(BlendFactor::One),
    });
    let target = wgpu::ColorTargetState {
        format: wgpu_format(format),
        blend,
        write_mask: wgpu::ColorWrites::ALL,
    };
    let pipeline = draw_pipeline(
        gpu,
        "raster",
        &bindings,
        &bound,
        &wgsl::QUADS_VERTEX,
        &wgsl::QUADS_FRAGMENT,
        target,
    )?;
    Ok(Way::Quads {
        bindings,
        pipeline,
        indices,
    })
}

/// A pipeline that draws triangles without depth. `bound`: what `bindings` were made of.
///
/// # Errors
/// Where the driver crashes when it draws triangles.
pub fn draw_pipeline(
    gpu: &Gpu,
    label: &'static str,
    bindings: &Bindings,
    bound: &[(u32, Bound)],
    vertex: &wgsl::WgslModule,
    fragment: &wgsl::WgslModule,
    target: wgpu::ColorTargetState,
) -> Result<wgpu::RenderPipeline> {
    if !draws_triangles(gpu.name()) {
        return Err(Error::Unsupported {
            device: gpu.name().into(),
            missing: NO_TRIANGLES,
        });
    }
    Ok(gpu
        .device
        .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
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

fn tiles(
    gpu: &Gpu,
    blocks: &Blocks,
    inputs: RasterInputs,
    format: ColorFormat,
    view: &wgpu::TextureView,
) -> Result<Way> {
    let lists = empty(
        gpu,
        "tile lists",
        TILING_WEB.bytes(inputs.capacity)[1],
        STORAGE,
    )?;
    let bound = [
        blocks.frame(),
        (1, Bound::Read(inputs.order)),
        (2, Bound::Read(inputs.splats)),
        (3, Bound::Write(inputs.control.into())),
        (4, Bound::Write((&lists).into())),
        blocks.settings(),
    ];
    let binning = Kernel::new(gpu, &wgsl::BINNING, &bound);
    let raster = Box::new(Kernel::new(
        gpu,
        &wgsl::RASTER,
        &tile_bindings(blocks, inputs, &lists, format, view),
    ));
    Ok(Way::Tiles {
        binning,
        raster,
        lists,
    })
}

fn tile_bindings<'a>(
    blocks: &'a Blocks,
    inputs: RasterInputs<'a>,
    lists: &'a wgpu::Buffer,
    format: ColorFormat,
    view: &'a wgpu::TextureView,
) -> [(u32, Bound<'a>); 7] {
    [
        blocks.frame(),
        (1, Bound::Read(inputs.splats)),
        (2, Bound::Write(inputs.control.into())),
        (3, Bound::Read(lists.into())),
        (4, Bound::FrameImage(view, wgpu_format(format))),
        (5, Bound::Read(inputs.keys)),
        blocks.settings(),
    ]
}
