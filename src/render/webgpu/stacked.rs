//! An array that every set of Gaussians has, an avatar's own and each of its levels', in one
//! buffer.

use super::{
    buffer::{STORAGE, Slice, partly_bound},
    device::Gpu,
    error::Result,
    owned::Buffer,
};

/// Offsets of bindings are multiples of this: the largest alignment that a device may ask for.
const ALIGNMENT: u64 = 256;

/// Sets lie one after the other, the largest last. Each is bound with as many bytes as the largest
/// takes, which reach into the sets behind it: a kernel is compiled for the lengths of its arrays,
/// and this one serves all sets.
pub struct Stacked {
    buffer: Buffer,
    /// Where each set starts, bytes.
    starts: Vec<u64>,
    /// Bytes that each is bound with.
    window: u64,
}

impl Stacked {
    /// Zeros, for sets of so many bytes: at least one.
    pub fn empty(gpu: &Gpu, name: &'static str, sizes: &[u64]) -> Result<Self> {
        let mut order: Vec<usize> = (0..sizes.len()).collect();
        order.sort_by_key(|&set| sizes[set]);
        let mut starts = vec![0; sizes.len()];
        let mut next = 0;
        let mut last = 0;
        for set in order {
            starts[set] = next;
            last = next;
            next += sizes[set].next_multiple_of(ALIGNMENT);
        }
        let largest = sizes.iter().copied().max().unwrap_or(0);
        // No binding may be empty.
        let window = largest.next_multiple_of(4).max(16);
        Ok(Self {
            buffer: partly_bound(gpu, name, last + window, window, STORAGE)?,
            starts,
            window,
        })
    }

    /// What kernels are bound to for a set.
    pub fn set(&self, set: usize) -> Slice<'_> {
        Slice {
            buffer: &self.buffer,
            offset: self.starts[set],
            size: self.window,
        }
    }

    /// Fills a set.
    pub fn write(&self, gpu: &Gpu, set: usize, data: &[u8]) {
        gpu.queue.write_buffer(&self.buffer, self.starts[set], data);
    }

    /// Copies the first set of another, of so many bytes, a multiple of 4.
    pub fn copy_first(&self, encoder: &mut wgpu::CommandEncoder, from: &Self, size: u64) {
        let [to, start] = [self, from].map(|stack| stack.starts[0]);
        encoder.copy_buffer_to_buffer(&from.buffer, start, &self.buffer, to, size);
    }
}
