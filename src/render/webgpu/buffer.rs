//! Buffers of a device.

use super::{
    device::Gpu,
    error::{Error, Result},
    owned::{Buffer, Owned},
};
use wgpu::BufferUsages;

/// Usage of buffers that kernels read and write; they can be read back and cleared.
pub const STORAGE: BufferUsages = BufferUsages::STORAGE
    .union(BufferUsages::COPY_SRC)
    .union(BufferUsages::COPY_DST);

/// A buffer of at least some bytes, zeros.
pub fn empty(gpu: &Gpu, name: &'static str, size: u64, usage: BufferUsages) -> Result<Buffer> {
    partly_bound(gpu, name, size, size, usage)
}

/// A buffer of at least some bytes, zeros, of which no binding has more than `bound`.
pub fn partly_bound(
    gpu: &Gpu,
    name: &'static str,
    size: u64,
    bound: u64,
    usage: BufferUsages,
) -> Result<Buffer> {
    let limits = gpu.device.limits();
    let binding = if usage.contains(BufferUsages::STORAGE) {
        limits.max_storage_buffer_binding_size
    } else {
        limits.max_buffer_size
    };
    for (found, limit) in [(bound, binding), (size, limits.max_buffer_size)] {
        if found > limit {
            return Err(Error::TooLarge {
                what: name,
                found,
                limit,
                device: gpu.name().into(),
            });
        }
    }
    let size = size.next_multiple_of(4).max(16);
    Ok(Owned(gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(name),
        size,
        usage,
        mapped_at_creation: false,
    })))
}

/// A buffer with something in it.
pub fn filled(gpu: &Gpu, name: &'static str, data: &[u8], usage: BufferUsages) -> Result<Buffer> {
    let buffer = empty(gpu, name, data.len() as u64, usage | BufferUsages::COPY_DST)?;
    let whole = data.len() & !3;
    gpu.queue.write_buffer(&buffer, 0, &data[..whole]);
    if whole < data.len() {
        let mut last = [0; 4];
        last[..data.len() - whole].copy_from_slice(&data[whole..]);
        gpu.queue.write_buffer(&buffer, whole as u64, &last);
    }
    Ok(buffer)
}

/// Part of a buffer, bytes from an offset that is a multiple of 256.
#[derive(Clone, Copy)]
pub struct Slice<'a> {
    pub buffer: &'a wgpu::Buffer,
    pub offset: u64,
    pub size: u64,
}

impl<'a> From<&'a wgpu::Buffer> for Slice<'a> {
    fn from(buffer: &'a wgpu::Buffer) -> Self {
        Self {
            buffer,
            offset: 0,
            size: buffer.size(),
        }
    }
}

impl<'a> From<&'a Buffer> for Slice<'a> {
    fn from(buffer: &'a Buffer) -> Self {
        (&**buffer).into()
    }
}

/// Reads part of a buffer back: waits.
#[cfg(not(target_arch = "wasm32"))]
pub fn download(gpu: &Gpu, from: Slice) -> Result<Vec<u8>> {
    let staging = empty(
        gpu,
        "read-back",
        from.size,
        BufferUsages::MAP_READ | BufferUsages::COPY_DST,
    )?;
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    encoder.copy_buffer_to_buffer(
        from.buffer,
        from.offset,
        &staging,
        0,
        from.size
            .next_multiple_of(4)
            .min(from.buffer.size() - from.offset),
    );
    mapped(gpu, &staging, encoder.finish(), from.size as usize)
}

/// Submits what fills a buffer, waits, and copies the buffer's first bytes out.
#[cfg(not(target_arch = "wasm32"))]
pub fn mapped(
    gpu: &Gpu,
    staging: &wgpu::Buffer,
    commands: wgpu::CommandBuffer,
    bytes: usize,
) -> Result<Vec<u8>> {
    gpu.queue.submit([commands]);
    staging.map_async(wgpu::MapMode::Read, .., |_| {});
    gpu.wait(None, "reading back")?;
    let view = staging
        .get_mapped_range(..)
        .map_err(|error| Error::Refused(error.to_string()))?;
    Ok(view[..bytes].to_vec())
}
