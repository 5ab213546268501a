//! Copies from buffer to buffer.

use crate::vulkan::{
    commands::{RunTimes, Stopwatch},
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::{Buffer, Scope},
    pipeline::{Kernel, Launch, Resources, shaders},
};
use ash::vk;
use effigy_core::layout::RATES_WORKGROUP;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// Bytes that an invocation copies.
const QUAD: u64 = 16;
/// Most workgroups in a row of a dispatch. Every device can have twice as many.
const ROW: u32 = 1 << 15;

/// What copies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CopyMethod {
    /// A kernel, 16 bytes an invocation.
    Kernel,
    /// A transfer command.
    Transfer,
}

impl CopyMethod {
    /// Every method.
    pub const ALL: [Self; 2] = [Self::Kernel, Self::Transfer];

    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Kernel => "kernel",
            Self::Transfer => "transfer",
        }
    }
}

/// Two buffers, and what copies from one to the other.
pub struct Copy {
    gpu: Arc<Gpu>,
    kernel: Kernel,
    from: Buffer,
    to: Buffer,
    bytes: u64,
    stopwatch: Stopwatch,
}

impl Copy {
    /// Copies of so many bytes, rounded down to a multiple of 16, at least 16.
    pub fn new(gpu: &Arc<Gpu>, bytes: u64) -> Result<Self> {
        let count = (bytes / QUAD).max(1);
        let bytes = count * QUAD;
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_SRC
            | vk::BufferUsageFlags::TRANSFER_DST;
        let buffer = |name| Buffer::new(gpu, name, bytes, usage, MemoryLocation::GpuOnly);
        let from = buffer("copied from")?;
        let to = buffer("copied to")?;
        let resources = Resources {
            storage: &[(&from).into(), (&to).into()],
            ..Resources::default()
        };
        let kernel = Kernel::new(
            gpu,
            &shaders::RATES_COPY,
            &[count as u32],
            resources,
            Launch::default(),
        )?;
        Ok(Self {
            gpu: gpu.clone(),
            kernel,
            from,
            to,
            bytes,
            stopwatch: Stopwatch::new(gpu, "copies")?,
        })
    }

    /// Bytes that a copy reads, and as many that it writes.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Gives the first buffer numbers of its own, and the second none: it may lie where an earlier
    /// copy did.
    pub fn load(&self) -> Result<()> {
        self.from.upload(bytemuck::cast_slice(&self.numbers()))?;
        self.gpu.run("clearing a copy", |commands| {
            // SAFETY: the buffer is alive, and `run` waits; its size is a multiple of 4.
            unsafe { commands.clear((&self.to).into()) };
        })
    }

    fn numbers(&self) -> Vec<u32> {
        (0..(self.bytes / 4) as u32)
            .map(|at| at.wrapping_mul(0x9E37_79B9))
            .collect()
    }

    /// Whether the second buffer holds what [`Self::load`] gave the first.
    pub fn is_copied(&self) -> Result<bool> {
        let found = self.to.download(self.bytes as usize)?;
        Ok(found == bytemuck::cast_slice::<u32, u8>(&self.numbers()))
    }

    /// Copies so many times, each after the one before has ended, as the stages of a frame do.
    pub fn time(&self, method: CopyMethod, times: u32) -> Result<RunTimes> {
        let nothing = |_: Recording| ();
        self.stopwatch.time("copies", nothing, |commands| {
            for _ in 0..times {
                self.record(commands, method);
            }
        })
    }

    fn record(&self, commands: Recording, method: CopyMethod) {
        match method {
            CopyMethod::Kernel => {
                let groups = (self.bytes / QUAD).div_ceil(u64::from(RATES_WORKGROUP)) as u32;
                let columns = groups.min(ROW);
                let rows = groups.div_ceil(columns);
                self.kernel.dispatch_2d(commands, 0, [columns, rows]);
                commands.barrier(Scope::KERNEL, Scope::KERNEL);
            }
            CopyMethod::Transfer => {
                let region = vk::BufferCopy {
                    src_offset: 0,
                    dst_offset: 0,
                    size: self.bytes,
                };
                // SAFETY: the command buffer is recording; both buffers are alive until the
                // stopwatch has waited, and hold the region.
                unsafe {
                    self.gpu.raw.cmd_copy_buffer(
                        commands.raw(),
                        self.from.raw(),
                        self.to.raw(),
                        &[region],
                    )
                };
                commands.barrier(Scope::TRANSFER_WRITES, Scope::TRANSFER_WRITES);
            }
        }
    }
}
