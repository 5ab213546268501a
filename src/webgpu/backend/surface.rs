//! The `surface` stage: what no one can see. The avatar's solid inside is drawn, seen from the camera, into a small depth image, and
//! reduced to a pyramid whose texels hold the furthest depth of what they cover: `splats` leaves out what lies behind that.

use super::{
    buffer::{STORAGE, filled},
    device::Gpu,
    error::Result,
    kernel::{Bindings, Blocks, Bound, Kernel, module},
    model::Model,
    owned::{Buffer, Texture},
    slot::Slot,
};
use crate::{
    avatar::{Avatar, Occluder},
    layout::{SURFACE_DRAWN, SURFACE_FINEST, SURFACE_HEIGHT, SURFACE_WIDTH, pack},
    webgpu::shaders,
};
use bytemuck::cast_slice;
use wgpu::{BufferUsages, Face, LoadOp, Operations, RenderPassDepthStencilAttachment, ShaderStages, StoreOp, TextureFormat, TextureUsages};

const FORMAT: TextureFormat = TextureFormat::Depth16Unorm;

/// The avatar's solid inside in device memory; see `shaders/surface.vert`.
pub struct Surface {
    _corners: Buffer,
    indices: Buffer,
    /// Of the mesh: corners and triangles.
    size: [u32; 2],
    mesh: Bindings,
    pipeline: wgpu::RenderPipeline,
    pyramid: Kernel,
    _image: Texture,
    view: wgpu::TextureView,
}

impl Surface {
    /// Writes the pyramid to `pose`, from the word on that the frame says. None for an avatar that has nothing solid.
    pub fn new(gpu: &Gpu, avatar: &Avatar, model: &Model, (blocks, pose): (&Blocks, &wgpu::Buffer)) -> Result<Option<Self>> {
        let (corners, triangles) = pack::occluder(avatar, &Occluder::new(avatar), &model.node_places);
        if triangles.is_empty() {
            return Ok(None);
        }
        let size = [corners.len() as u32, triangles.len() as u32];
        let corners = filled(gpu, "surface corners", cast_slice(&corners), STORAGE)?;
        let indices = filled(gpu, "surface indices", cast_slice(&triangles), BufferUsages::INDEX)?;
        let drawn = [blocks.frame(), (1, Bound::Read((&corners).into())), (2, Bound::Read(pose.into()))];
        let mesh = Bindings::new(gpu, ShaderStages::VERTEX, &drawn);
        let usage = TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING;
        let image = super::raster::texture(gpu, "surface", [SURFACE_DRAWN; 2], FORMAT, usage);
        let view = image.create_view(&Default::default());
        let bound = [blocks.frame(), (1, Bound::Write(pose.into())), (2, Bound::Texture(&view))];
        let pyramid = Kernel::new(gpu, &shaders::SURFACE, &bound);
        let pipeline = gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("surface"),
            layout: Some(&mesh.pipeline_layout(gpu)),
            vertex: wgpu::VertexState {
                module: &module(gpu, &shaders::SURFACE_VERTEX, &drawn),
                entry_point: None,
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState { cull_mode: Some(Face::Back), ..Default::default() },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: FORMAT,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::LessEqual),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: Default::default(),
            fragment: None,
            multiview_mask: None,
            cache: None,
        });
        Ok(Some(Self { _corners: corners, indices, size, mesh, pipeline, pyramid, _image: image, view }))
    }

    /// Corners and triangles of the mesh.
    pub fn size(&self) -> [u64; 2] {
        self.size.map(u64::from)
    }

    /// Draws the mesh of each of `frames`, at least one, where their blocks say.
    pub fn record(&self, slot: &mut Slot, encoder: &mut wgpu::CommandEncoder, frames: &[u32]) {
        let [first, second] = slot.split("surface");
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("surface"),
                depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
                    view: &self.view,
                    depth_ops: Some(Operations { load: LoadOp::Clear(1.0), store: StoreOp::Store }),
                    stencil_ops: None,
                }),
                timestamp_writes: slot.draw_writes(first),
                ..Default::default()
            });
            pass.set_pipeline(&self.pipeline);
            pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
            for &frame in frames {
                self.mesh.bind_draw(&mut pass, frame);
                pass.draw_indexed(0..3 * self.size[1], 0, 0..1);
            }
        }
        let mut pass = slot.pass(encoder, "surface", second);
        self.pyramid.dispatch(&mut pass, frames[0], [SURFACE_FINEST / SURFACE_WIDTH, SURFACE_FINEST / SURFACE_HEIGHT]);
    }
}
