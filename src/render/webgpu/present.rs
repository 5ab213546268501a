//! The `present` stage: the image goes in, a canvas or window with the image over a background
//! comes out.

use super::{
    buffer,
    device::Gpu,
    drawing::TrianglePipeline,
    error::Result,
    kernel::{Bindings, Bound},
    owned::Buffer,
};
use crate::wgsl;
use wgpu::{BufferUsages, ShaderStages, TextureFormat};

/// Draws images over a background.
pub struct Present {
    background: Buffer,
    bindings: Bindings,
    pipeline: wgpu::RenderPipeline,
}

impl Present {
    /// For targets of a format whose numbers are shown as they are.
    pub fn new(gpu: &Gpu, image: &wgpu::TextureView, format: TextureFormat) -> Result<Self> {
        let background = buffer::empty(
            gpu,
            "background",
            16,
            BufferUsages::UNIFORM | BufferUsages::COPY_DST,
        )?;
        let bound = bound(image, &background);
        let bindings = Bindings::new(gpu, ShaderStages::FRAGMENT, &bound);
        let target = wgpu::ColorTargetState {
            format,
            blend: None,
            write_mask: wgpu::ColorWrites::ALL,
        };
        let drawing = TrianglePipeline {
            label: "present",
            bindings: &bindings,
            bound: &bound,
            vertex: &wgsl::PRESENT_VERTEX,
            fragment: &wgsl::PRESENT_FRAGMENT,
            target,
            depth: None,
        };
        let pipeline = drawing.pipeline(gpu)?;
        Ok(Self {
            background,
            bindings,
            pipeline,
        })
    }

    /// Shows this image from now on.
    pub fn set_image(&mut self, gpu: &Gpu, image: &wgpu::TextureView) {
        self.bindings.set(gpu, 0, &bound(image, &self.background));
    }

    /// Draws the image over a background, display-referred RGB.
    pub fn draw(&self, gpu: &Gpu, target: &wgpu::TextureView, [r, g, b]: [f32; 3]) {
        gpu.queue
            .write_buffer(&self.background, 0, bytemuck::cast_slice(&[r, g, b, 1.0]));
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("present"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: target,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                        store: wgpu::StoreOp::Store,
                    },
                })],
                ..Default::default()
            });
            pass.set_pipeline(&self.pipeline);
            self.bindings.bind_draw(&mut pass, 0);
            pass.draw(0..3, 0..1);
        }
        gpu.queue.submit([encoder.finish()]);
    }
}

fn bound<'a>(image: &'a wgpu::TextureView, background: &'a wgpu::Buffer) -> [(u32, Bound<'a>); 2] {
    [(0, Bound::Texture(image)), (1, Bound::Uniform(background))]
}
