//! Buffers that free themselves, and copies into and out of them.

use super::{allocation::Allocation, barrier::Scope};
use crate::vulkan::device::{
    error::{During, Error, Result},
    gpu::Gpu,
    handle::BufferHandle,
    recording::Recording,
};
use ash::vk::{self, AccessFlags, PipelineStageFlags};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// The smallest buffer, bytes.
const LEAST: u64 = 16;

/// A buffer and its memory.
pub struct Buffer {
    // The buffer goes before the memory that it is bound to.
    handle: BufferHandle,
    allocation: Allocation,
    /// Bytes.
    pub(crate) size: u64,
    gpu: Arc<Gpu>,
}

/// A part of a buffer that a shader sees. It keeps nothing alive: what takes slices says how long
/// their buffers must live.
#[derive(Clone, Copy)]
pub struct Slice {
    pub(crate) buffer: vk::Buffer,
    /// Bytes; a multiple of the device's storage buffer alignment, at most 256.
    pub(crate) offset: u64,
    /// Bytes.
    pub(crate) size: u64,
}

impl Slice {
    /// Bytes.
    pub fn size(self) -> u64 {
        self.size
    }

    /// A part of it. `offset`, from its own start, and `size`: bytes.
    ///
    /// # Panics
    /// When it does not hold the part.
    pub fn part(self, offset: u64, size: u64) -> Self {
        assert!(
            offset.checked_add(size).is_some_and(|end| end <= self.size),
            "a slice of {} bytes has no part of {size} at {offset}",
            self.size
        );
        Self {
            offset: self.offset + offset,
            size,
            ..self
        }
    }
}

/// A buffer in place of another: what bound a part of the one binds that part of the other, and
/// what bound it whole binds the other whole.
#[derive(Clone, Copy)]
pub(crate) struct Replacement {
    /// The whole buffer before.
    pub old: Slice,
    /// The whole buffer now.
    pub new: Slice,
}

impl Replacement {
    /// What takes the place of a slice. None where it is of another buffer.
    pub fn of(&self, slice: Slice) -> Option<Slice> {
        let is_whole = slice.offset == 0 && slice.size == self.old.size;
        (slice.buffer == self.old.buffer).then_some(Slice {
            buffer: self.new.buffer,
            size: if is_whole { self.new.size } else { slice.size },
            ..slice
        })
    }

    /// Puts what takes the place of a slice there.
    pub fn apply(&self, slice: &mut Slice) {
        *slice = self.of(*slice).unwrap_or(*slice);
    }
}

impl From<&Buffer> for Slice {
    fn from(buffer: &Buffer) -> Self {
        Self {
            buffer: buffer.raw(),
            offset: 0,
            size: buffer.size,
        }
    }
}

/// Data for the start of a buffer of the device's own.
pub(crate) struct Upload<'a> {
    pub to: &'a Buffer,
    pub data: &'a [u8],
}

impl Upload<'_> {
    /// Whether a buffer made for this data would have that one's size.
    pub fn fills(&self) -> bool {
        self.to.size == (self.data.len() as u64).max(LEAST)
    }
}

/// Copies data to buffers at once, and waits. What may fail but for the device itself, making room
/// to copy from, comes before anything is written.
///
/// # Panics
/// When data is longer than its buffer.
pub(crate) fn upload_all(gpu: &Arc<Gpu>, uploads: &[Upload]) -> Result<()> {
    let size: usize = uploads.iter().map(|upload| upload.data.len()).sum();
    let usage = vk::BufferUsageFlags::TRANSFER_SRC;
    let location = MemoryLocation::CpuToGpu;
    let mut staging = Buffer::new(gpu, "staging", size as u64, usage, location)?;
    let mut start = 0;
    for upload in uploads {
        upload.to.assert_holds(upload.data.len());
        staging.mapped()[start..][..upload.data.len()].copy_from_slice(upload.data);
        start += upload.data.len();
    }
    gpu.run("an upload", |commands| {
        let mut start = 0;
        for upload in uploads.iter().filter(|upload| !upload.data.is_empty()) {
            let region = vk::BufferCopy {
                src_offset: start,
                dst_offset: 0,
                size: upload.data.len() as u64,
            };
            start += region.size;
            let [from, to] = [staging.raw(), upload.to.raw()];
            // SAFETY: both buffers are alive; the region is inside both, as asserted above; `run`
            // waits.
            unsafe { gpu.raw.cmd_copy_buffer(commands.raw(), from, to, &[region]) };
        }
    })
}

impl Buffer {
    /// `size` is rounded up to at least 16 bytes: Vulkan has no empty buffers, avatars have empty
    /// arrays.
    pub fn new(
        gpu: &Arc<Gpu>,
        name: &'static str,
        size: u64,
        usage: vk::BufferUsageFlags,
        location: MemoryLocation,
    ) -> Result<Self> {
        let size = size.max(LEAST);
        let limit = u64::from(gpu.probe.limits.max_storage_buffer_range);
        if usage.contains(vk::BufferUsageFlags::STORAGE_BUFFER) && size > limit {
            return Err(Error::TooLarge {
                what: name,
                found: size,
                limit,
                device: gpu.probe.name.clone(),
            });
        }
        let info = vk::BufferCreateInfo::default().size(size).usage(usage);
        // SAFETY: `info` outlives the call; the buffer is new and belongs to its owner.
        let handle = unsafe {
            let raw = gpu
                .raw
                .create_buffer(&info, None)
                .during("vkCreateBuffer")?;
            BufferHandle::new(&gpu.device, raw, name)
        };
        // SAFETY: the buffer is alive.
        let requirements = unsafe { gpu.raw.get_buffer_memory_requirements(handle.raw()) };
        let allocation = Allocation::new(gpu, name, requirements, location, true)?;
        let (memory, offset) = allocation.place();
        // SAFETY: buffer and memory are new and fit, as the requirements say.
        unsafe { gpu.raw.bind_buffer_memory(handle.raw(), memory, offset) }
            .during("vkBindBufferMemory")?;
        Ok(Self {
            handle,
            allocation,
            size,
            gpu: gpu.clone(),
        })
    }

    /// A buffer of the device's own that shaders read, filled once.
    pub fn with_data(
        gpu: &Arc<Gpu>,
        name: &'static str,
        data: &[u8],
        usage: vk::BufferUsageFlags,
    ) -> Result<Self> {
        let buffer = Self::new(
            gpu,
            name,
            data.len() as u64,
            usage | vk::BufferUsageFlags::TRANSFER_DST,
            MemoryLocation::GpuOnly,
        )?;
        buffer.upload(data)?;
        Ok(buffer)
    }

    /// The buffer, for as long as its owner lives.
    pub fn raw(&self) -> vk::Buffer {
        self.handle.raw()
    }

    /// Mapped bytes of a buffer that the host sees. Empty for others.
    pub fn mapped(&mut self) -> &mut [u8] {
        self.allocation.mapped()
    }

    /// Copies data to the start of a buffer of the device's own, and waits.
    ///
    /// # Panics
    /// When the data is longer than the buffer.
    pub fn upload(&self, data: &[u8]) -> Result<()> {
        /// Staging never takes more than this, whatever the avatar's size.
        const CHUNK: usize = 8 << 20;
        self.assert_holds(data.len());
        if data.is_empty() {
            return Ok(());
        }
        let size = data.len().min(CHUNK) as u64;
        let mut staging = Self::new(
            &self.gpu,
            "staging",
            size,
            vk::BufferUsageFlags::TRANSFER_SRC,
            MemoryLocation::CpuToGpu,
        )?;
        for (at, chunk) in data.chunks(CHUNK).enumerate() {
            staging.mapped()[..chunk.len()].copy_from_slice(chunk);
            let region = vk::BufferCopy {
                src_offset: 0,
                dst_offset: (at * CHUNK) as u64,
                size: chunk.len() as u64,
            };
            // SAFETY: both buffers are alive; the region is inside both, as asserted above; `run`
            // waits.
            self.gpu.run("an upload", |commands| unsafe {
                self.gpu
                    .raw
                    .cmd_copy_buffer(commands.raw(), staging.raw(), self.raw(), &[region])
            })?;
        }
        Ok(())
    }

    /// That so many bytes are inside the buffer.
    fn assert_holds(&self, bytes: usize) {
        assert!(
            bytes as u64 <= self.size,
            "a buffer of {} bytes does not hold {bytes}",
            self.size
        );
    }

    /// Copies the start of a buffer back, and waits: for images and tests.
    ///
    /// # Panics
    /// When the buffer has fewer bytes.
    pub fn download(&self, bytes: usize) -> Result<Vec<u8>> {
        self.assert_holds(bytes);
        if bytes == 0 {
            return Ok(Vec::new());
        }
        let size = bytes as u64;
        let mut staging = Self::new(
            &self.gpu,
            "read-back",
            size,
            vk::BufferUsageFlags::TRANSFER_DST,
            MemoryLocation::GpuToCpu,
        )?;
        let region = vk::BufferCopy {
            src_offset: 0,
            dst_offset: 0,
            size,
        };
        let all = Scope::new(PipelineStageFlags::ALL_COMMANDS, AccessFlags::MEMORY_WRITE);
        self.gpu.run("a read-back", |commands| {
            commands.barrier(all, Scope::TRANSFER_READS);
            // SAFETY: both buffers are alive; the region is inside both, as asserted above; `run`
            // waits.
            unsafe {
                self.gpu
                    .raw
                    .cmd_copy_buffer(commands.raw(), self.raw(), staging.raw(), &[region])
            };
            commands.show_host();
        })?;
        Ok(staging.mapped()[..bytes].to_vec())
    }
}

impl Recording<'_> {
    /// Zeroes a part of a buffer: a transfer.
    ///
    /// # Safety
    /// The buffer must be alive until the commands are done, and hold the part; offset and size are
    /// multiples of 4.
    pub(crate) unsafe fn clear(self, part: Slice) {
        // SAFETY: the command buffer is recording; the caller promises that the part lies in a
        // buffer that is alive.
        unsafe {
            self.device()
                .raw
                .cmd_fill_buffer(self.raw(), part.buffer, part.offset, part.size, 0)
        };
    }
}
