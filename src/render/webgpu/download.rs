//! Brings images from the device to the host.

use super::{buffer, device::Gpu, error::Result, raster::Raster};
use effigy_core::{frame::ColorFormat, scene::FrameImage};
use half::f16;
use wgpu::BufferUsages;

/// Copies an image that was drawn at least once, and waits.
pub fn read_image(gpu: &Gpu, raster: &Raster) -> Result<FrameImage> {
    let image = raster.image();
    let bytes = texels(gpu, image, raster.format().bytes())?;
    let pixels = match raster.format() {
        ColorFormat::Rgba8 => bytes
            .chunks_exact(4)
            .map(|p| [p[0], p[1], p[2], p[3]].map(|v| f32::from(v) / 255.0))
            .collect(),
        ColorFormat::Rgba16F => {
            let half = |p: &[u8], k: usize| f16::from_le_bytes([p[2 * k], p[2 * k + 1]]).to_f32();
            bytes
                .chunks_exact(8)
                .map(|p| std::array::from_fn(|k| half(p, k)))
                .collect()
        }
    };
    Ok(FrameImage {
        size: [image.width(), image.height()],
        pixels,
    })
}

/// Copies the texels of a texture, each of some bytes, row by row, and waits.
pub fn texels(gpu: &Gpu, texture: &wgpu::Texture, bytes_each: usize) -> Result<Vec<u8>> {
    let width = texture.width();
    let height = texture.height();
    let row = width as usize * bytes_each;
    let pitch = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize);
    let bytes = pitch * height as usize;
    let staging = buffer::empty(
        gpu,
        "image copy",
        bytes as u64,
        BufferUsages::MAP_READ | BufferUsages::COPY_DST,
    )?;
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(pitch as u32),
        rows_per_image: None,
    };
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &staging,
            layout,
        },
        wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
    );
    let bytes = buffer::mapped(gpu, &staging, encoder.finish(), bytes)?;
    let rows = bytes.chunks_exact(pitch);
    Ok(rows.flat_map(|line| &line[..row]).copied().collect())
}
