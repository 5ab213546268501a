//! The `occluder` stage: finds what the avatar itself hides. The occluder mesh is drawn from the
//! camera into a small depth image, which is reduced to a pyramid: each texel holds the furthest
//! depth of the pixels under it. `project` culls Gaussians behind that depth.

use super::{
    buffer::{STORAGE, filled},
    device::Gpu,
    drawing::{DEPTH_FORMAT, depth_test, texture},
    error::Result,
    frame_in_flight::{FrameInFlight, Writes},
    kernel::{Bindings, Blocks, Bound, Kernel, module},
    model::Model,
    owned::{Buffer, Texture},
};
use crate::wgsl;
use bytemuck::cast_slice;
use effigy_core::{
    avatar::Avatar,
    frame::Stage,
    layout::{
        OCCLUDER_SIDE, PYRAMID_SIDE, PYRAMID_WORKGROUP_HEIGHT, PYRAMID_WORKGROUP_WIDTH, pack,
    },
    occluder::Occluder,
};
use wgpu::{
    BufferUsages, Face, LoadOp, Operations, RenderPassDepthStencilAttachment, ShaderStages,
    StoreOp, TextureUsages,
};

/// The occluder mesh in device memory, and its pipelines; see `shaders/occluder/depth.vert`.
pub struct OccluderPass {
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

impl OccluderPass {
    /// Writes the pyramid to `pose`, from the word on that the frame says. None for an avatar
    /// without an occluder.
    pub fn new(
        gpu: &Gpu,
        avatar: &Avatar,
        model: &Model,
        blocks: &Blocks,
        pose: &wgpu::Buffer,
    ) -> Result<Option<Self>> {
        let (corners, triangles) =
            pack::occluder(avatar, &Occluder::new(avatar), &model.node_places);
        if triangles.is_empty() {
            return Ok(None);
        }
        let size = [corners.len() as u32, triangles.len() as u32];
        let corners = filled(gpu, "occluder corners", cast_slice(&corners), STORAGE)?;
        let indices = filled(
            gpu,
            "occluder indices",
            cast_slice(&triangles),
            BufferUsages::INDEX,
        )?;
        let drawn = [
            blocks.frame(),
            (1, Bound::Read((&corners).into())),
            (2, Bound::Read(pose.into())),
        ];
        let mesh = Bindings::new(gpu, ShaderStages::VERTEX, &drawn);
        let usage = TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING;
        let image = texture(gpu, "occluder", [OCCLUDER_SIDE; 2], DEPTH_FORMAT, usage);
        let view = image.create_view(&Default::default());
        let bound = [
            blocks.frame(),
            (1, Bound::Write(pose.into())),
            (2, Bound::Texture(&view)),
        ];
        let pyramid = Kernel::new(gpu, &wgsl::OCCLUDER_PYRAMID, &bound);
        let pipeline = gpu
            .device
            .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(Stage::Occluder.name()),
                layout: Some(&mesh.pipeline_layout(gpu)),
                vertex: wgpu::VertexState {
                    module: &module(gpu, &wgsl::OCCLUDER_DEPTH, &drawn),
                    entry_point: None,
                    compilation_options: Default::default(),
                    buffers: &[],
                },
                primitive: wgpu::PrimitiveState {
                    cull_mode: Some(Face::Back),
                    ..Default::default()
                },
                depth_stencil: Some(depth_test(true)),
                multisample: Default::default(),
                fragment: None,
                multiview_mask: None,
                cache: None,
            });
        Ok(Some(Self {
            _corners: corners,
            indices,
            size,
            mesh,
            pipeline,
            pyramid,
            _image: image,
            view,
        }))
    }

    /// Corners and triangles of the mesh.
    pub fn size(&self) -> [u64; 2] {
        self.size.map(u64::from)
    }

    /// Draws the mesh of each of `frames`, at least one, where their blocks say. `writes`: the
    /// timestamps of the whole.
    pub fn record(
        &self,
        frame: &FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        frames: &[u32],
        writes: Writes,
    ) {
        let [begin, end] = writes;
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some(Stage::Occluder.name()),
                depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
                    view: &self.view,
                    depth_ops: Some(Operations {
                        load: LoadOp::Clear(1.0),
                        store: StoreOp::Store,
                    }),
                    stencil_ops: None,
                }),
                timestamp_writes: frame.draw_writes([begin, None]),
                ..Default::default()
            });
            pass.set_pipeline(&self.pipeline);
            pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
            for &frame in frames {
                self.mesh.bind_draw(&mut pass, frame);
                pass.draw_indexed(0..3 * self.size[1], 0, 0..1);
            }
        }
        let mut pass = frame.pass(encoder, Stage::Occluder, [None, end]);
        self.pyramid.dispatch(
            &mut pass,
            frames[0],
            [
                PYRAMID_SIDE / PYRAMID_WORKGROUP_WIDTH,
                PYRAMID_SIDE / PYRAMID_WORKGROUP_HEIGHT,
            ],
        );
    }
}
