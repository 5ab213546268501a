//! Textures, and pipelines that draw triangles.

use super::{
    device::Gpu,
    error::{Error, Result},
    kernel::{Bindings, Bound, module},
    owned::{Owned, OwnedTexture},
};
use crate::{
    quirks::{NO_TRIANGLES, draws_triangles},
    wgsl::WgslModule,
};
use wgpu::{CompareFunction, DepthStencilState, TextureFormat, TextureUsages};

/// The format of depth images: every device draws to it and reads it.
pub const DEPTH_FORMAT: TextureFormat = TextureFormat::Depth16Unorm;

/// Makes a texture of one level and one sample.
pub fn texture(
    gpu: &Gpu,
    label: &'static str,
    [width, height]: [u32; 2],
    format: TextureFormat,
    usage: TextureUsages,
) -> OwnedTexture {
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

/// Fragments further away than what the depth image holds are left out. `writes`: the others'
/// depths are stored.
pub fn depth_test(writes: bool) -> DepthStencilState {
    DepthStencilState {
        format: DEPTH_FORMAT,
        depth_write_enabled: Some(writes),
        depth_compare: Some(CompareFunction::LessEqual),
        stencil: Default::default(),
        bias: Default::default(),
    }
}

/// A pipeline that draws triangles.
pub struct TrianglePipeline<'a> {
    pub label: &'static str,
    pub bindings: &'a Bindings,
    /// What `bindings` were made of.
    pub bound: &'a [(u32, Bound<'a>)],
    pub vertex: &'a WgslModule,
    pub fragment: &'a WgslModule,
    pub target: wgpu::ColorTargetState,
    /// None where the pass has no depth image.
    pub depth: Option<DepthStencilState>,
}

impl TrianglePipeline<'_> {
    /// # Errors
    /// Where the driver crashes when it draws triangles.
    pub fn pipeline(self, gpu: &Gpu) -> Result<wgpu::RenderPipeline> {
        if !draws_triangles(gpu.name()) {
            return Err(Error::Unsupported {
                device: gpu.name().into(),
                missing: NO_TRIANGLES,
            });
        }
        Ok(gpu
            .device
            .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(self.label),
                layout: Some(&self.bindings.pipeline_layout(gpu)),
                vertex: wgpu::VertexState {
                    module: &module(gpu, self.vertex, self.bound),
                    entry_point: None,
                    compilation_options: Default::default(),
                    buffers: &[],
                },
                primitive: Default::default(),
                depth_stencil: self.depth,
                multisample: Default::default(),
                fragment: Some(wgpu::FragmentState {
                    module: &module(gpu, self.fragment, self.bound),
                    entry_point: None,
                    compilation_options: Default::default(),
                    targets: &[Some(self.target)],
                }),
                multiview_mask: None,
                cache: None,
            }))
    }
}
