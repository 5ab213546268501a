//! The graphics form of `raster`: one indirect draw of quads, blended far to near.

use super::{
    super::{
        buffer,
        device::Gpu,
        drawing::{TrianglePipeline, depth_test},
        error::Result,
        frame_in_flight::{FrameInFlight, Writes},
        kernel::{Bindings, Blocks, Bound},
        owned::Buffer,
    },
    inputs::{Draw, RasterInputs},
    saturation::Saturation,
};
use crate::wgsl;
use effigy_core::{
    frame::{RendererOptions, Skip, Stage},
    layout::QUADS_PER_INSTANCE,
};
use wgpu::{
    BlendComponent, BlendFactor, BlendOperation, BlendState, LoadOp, Operations, ShaderStages,
    StoreOp, TextureFormat, TextureView,
};

/// What draws quads.
struct QuadPipeline {
    bindings: Bindings,
    pipeline: wgpu::RenderPipeline,
}

/// What a layer's quads are drawn with.
pub struct QuadFrame<'a> {
    /// What they are drawn to, in its upper left corner.
    pub image: &'a TextureView,
    pub draw: &'a Draw<'a>,
    /// Holds the arguments of the draw.
    pub control: &'a wgpu::Buffer,
    /// Whether the frame found the saturation depth, behind which nothing is drawn.
    pub tested: bool,
}

pub struct Quads {
    /// Draws every fragment.
    all: QuadPipeline,
    /// Draws those that the saturation depth leaves. None where no frame tests depth.
    tested: Option<Box<(Saturation, QuadPipeline)>>,
    indices: Buffer,
}

impl Quads {
    pub fn new(
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        format: TextureFormat,
        options: &RendererOptions,
    ) -> Result<Self> {
        let quad = |quad: u32| [0, 1, 2, 2, 1, 3].map(|corner| (4 * quad + corner) as u16);
        let indices: Vec<u16> = (0..QUADS_PER_INSTANCE).flat_map(quad).collect();
        let indices = buffer::filled(
            gpu,
            "quad indices",
            bytemuck::cast_slice(&indices),
            wgpu::BufferUsages::INDEX,
        )?;
        let tested = if options.skip.contains(Skip::DEPTH) {
            let saturation = Saturation::new(gpu, blocks, inputs, format, options.size)?;
            let tested = QuadPipeline::new(gpu, blocks, inputs, format, Some(&saturation))?;
            Some(Box::new((saturation, tested)))
        } else {
            None
        };
        Ok(Self {
            all: QuadPipeline::new(gpu, blocks, inputs, format, None)?,
            tested,
            indices,
        })
    }

    /// The stage that finds the saturation depths, if there is one.
    pub fn saturation(&self) -> Option<&Saturation> {
        self.tested.as_ref().map(|tested| &tested.0)
    }

    /// Changes the image's size.
    pub fn resize(&mut self, gpu: &Gpu, blocks: &Blocks, inputs: RasterInputs, size: [u32; 2]) {
        if let Some(tested) = &mut self.tested {
            tested.0.resize(gpu, blocks, inputs, size);
        }
    }

    /// Blends the quads into the cleared image. `writes`: its timestamps.
    pub fn record(
        &self,
        in_flight: &FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        frame: &QuadFrame,
        writes: Writes,
    ) {
        let tested = self.tested.as_ref().filter(|_| frame.tested);
        let depth = tested.map(|tested| wgpu::RenderPassDepthStencilAttachment {
            view: tested.0.depth(),
            depth_ops: Some(Operations {
                load: LoadOp::Clear(1.0),
                store: StoreOp::Discard,
            }),
            stencil_ops: None,
        });
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(Stage::Raster.name()),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: frame.image,
                depth_slice: None,
                resolve_target: None,
                ops: Operations {
                    load: LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: StoreOp::Store,
                },
            })],
            depth_stencil_attachment: depth,
            timestamp_writes: in_flight.draw_writes(writes),
            ..Default::default()
        });
        let [width, height] = frame.draw.size;
        pass.set_viewport(0.0, 0.0, width as f32, height as f32, 0.0, 1.0);
        // The samples outside are another frame's.
        let area = frame.draw.damage.drawn;
        let sides = area.max - area.min;
        pass.set_scissor_rect(area.min.x, area.min.y, sides.x, sides.y);
        let quads = match tested {
            Some(tested) => {
                tested.0.draw(&mut pass);
                &tested.1
            }
            None => &self.all,
        };
        pass.set_pipeline(&quads.pipeline);
        quads.bindings.bind_draw(&mut pass, frame.draw.block);
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        pass.draw_indexed_indirect(frame.control, 0);
    }
}

impl QuadPipeline {
    fn new(
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        format: TextureFormat,
        saturation: Option<&Saturation>,
    ) -> Result<Self> {
        let mut bound = vec![
            blocks.frame(),
            (1, Bound::Read(inputs.order)),
            (2, Bound::Read(inputs.splats)),
            (3, Bound::Read(inputs.control.into())),
            blocks.settings(),
        ];
        bound.extend(saturation.map(|saturation| (4, Bound::Read(saturation.bins().marks()))));
        let bindings = Bindings::new(gpu, ShaderStages::VERTEX_FRAGMENT, &bound);
        // "Over": C = αc + (1 − α) C, and coverage likewise, which leaves the image premultiplied.
        // The fragment's colour is not, so that a blender that rounds uses one rounded alpha for
        // both terms.
        let over = |src_factor| BlendComponent {
            src_factor,
            dst_factor: BlendFactor::OneMinusSrcAlpha,
            operation: BlendOperation::Add,
        };
        let blend = Some(BlendState {
            color: over(BlendFactor::SrcAlpha),
            alpha: over(BlendFactor::One),
        });
        let drawing = TrianglePipeline {
            label: "raster",
            bindings: &bindings,
            bound: &bound,
            vertex: match saturation {
                Some(_) => &wgsl::QUADS_TESTED_VERTEX,
                None => &wgsl::QUADS_VERTEX,
            },
            fragment: &wgsl::QUADS_FRAGMENT,
            target: wgpu::ColorTargetState {
                format,
                blend,
                write_mask: wgpu::ColorWrites::ALL,
            },
            depth: saturation.map(|_| depth_test(false)),
        };
        Ok(Self {
            pipeline: drawing.pipeline(gpu)?,
            bindings,
        })
    }
}
