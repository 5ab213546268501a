//! Convolutions and their gradient with respect to what they read, as products of matrices: a
//! column for each pixel that is written, a row for each number under the window.
//!
//! The work is cut into tasks by the shape alone and never by the number of threads, and parts of a
//! sum are added in their order: the same bits come out on every run.

use crate::{
    gemm::{StridedMatrix, multiply},
    maps::Maps,
    network::{ConvolutionShape, NetworkStep},
};
use rayon::prelude::*;
use std::{cell::Cell, ops::Range};

/// Columns of a task, about: they and a part of the weights stay in a core's cache.
const COLUMNS: usize = 512;
/// Where there are fewer bands of rows than this, channels are cut into parts too.
const TASKS: usize = 4;

thread_local! {
    /// Memory of a task that the next one on the thread uses again.
    static COLUMN_MEMORY: Cell<Vec<f32>> = const { Cell::new(Vec::new()) };
}

/// A convolution and its weights.
#[derive(Clone, Debug)]
pub struct Convolution {
    /// Its shape.
    pub shape: ConvolutionShape,
    /// Shape: to · from · window · window.
    pub weight: Vec<f32>,
    /// Shape: to.
    pub bias: Vec<f32>,
}

/// Rows of what is written that are one task, and the channels of it or of what is read.
#[derive(Clone)]
struct Task {
    rows: Range<usize>,
    channels: Range<usize>,
}

/// Cuts `size` and channels into tasks; the bands of rows of a part of the channels follow each
/// other.
fn tasks(size: [usize; 2], channels: usize) -> Vec<Task> {
    let bands = (size[0] * size[1]).div_ceil(COLUMNS).clamp(1, size[1]);
    let parts = TASKS.div_ceil(bands).min(channels);
    let cut = |count: usize, of: usize, at: usize| count * at / of..count * (at + 1) / of;
    (0..parts)
        .flat_map(|part| {
            (0..bands).map(move |band| Task {
                rows: cut(size[1], bands, band),
                channels: cut(channels, parts, part),
            })
        })
        .collect()
}

impl Convolution {
    /// A convolution with these weights.
    ///
    /// # Panics
    /// When there are not as many as the shape says.
    pub fn new(shape: ConvolutionShape, weight: Vec<f32>, bias: Vec<f32>) -> Self {
        assert!(weight.len() == shape.to * shape.fan() && bias.len() == shape.to);
        Self {
            shape,
            weight,
            bias,
        }
    }

    /// What it writes for feature maps. `rectify`: negative numbers become 0.
    pub fn forward(&self, input: &Maps, rectify: bool) -> Maps {
        let size = input
            .size
            .map(|side| NetworkStep::Convolve(self.shape).side(side));
        let fan = self.shape.fan();
        let tasks = tasks(size, self.shape.to);
        let tiles: Vec<Vec<f32>> = tasks
            .par_iter()
            .map(|task| {
                let columns = task.rows.len() * size[0];
                let mut tile = vec![0.0; task.channels.len() * columns];
                with_memory(fan * columns, |memory| {
                    self.gather(input, size, &task.rows, memory);
                    let weight = &self.weight[task.channels.start * fan..task.channels.end * fan];
                    multiply(
                        StridedMatrix::new(weight, task.channels.len(), fan),
                        StridedMatrix::new(memory, fan, columns),
                        &mut tile,
                    );
                });
                tile
            })
            .collect();
        let mut output = Maps::zeros(self.shape.to, size);
        let plane = output.plane();
        let each = output.data.par_chunks_exact_mut(plane).enumerate();
        each.for_each(|(channel, numbers)| {
            let bias = self.bias[channel];
            for (task, tile) in tasks.iter().zip(&tiles) {
                if !task.channels.contains(&channel) {
                    continue;
                }
                let columns = task.rows.len() * size[0];
                let row = &tile[(channel - task.channels.start) * columns..][..columns];
                let into = &mut numbers[task.rows.start * size[0]..][..columns];
                for (into, number) in into.iter_mut().zip(row) {
                    let number = number + bias;
                    *into = if rectify { number.max(0.0) } else { number };
                }
            }
        });
        output
    }

    /// The gradient with respect to what it read, from that with respect to what it wrote.
    /// `read`: the size of the former.
    pub fn backward(&self, gradient: &Maps, read: [usize; 2]) -> Maps {
        let size = gradient.size;
        let ConvolutionShape {
            window,
            pad,
            stride,
            ..
        } = self.shape;
        let fan = self.shape.fan();
        let plane = gradient.plane();
        let under = window * window;
        let tasks = tasks(size, self.shape.from);
        // Each task has rows of its own: those that its windows reach.
        let reach = |task: &Task| {
            let last = stride * (task.rows.end - 1) + window - pad;
            (stride * task.rows.start).saturating_sub(pad)..last.min(read[1])
        };
        let bands: Vec<Vec<f32>> = tasks
            .par_iter()
            .map(|task| {
                let columns = task.rows.len() * size[0];
                let rows = reach(task);
                let mut band = vec![0.0; task.channels.len() * rows.len() * read[0]];
                with_memory(task.channels.len() * under * columns, |memory| {
                    let weight = StridedMatrix {
                        numbers: &self.weight[task.channels.start * under..],
                        rows: self.shape.to,
                        columns: task.channels.len() * under,
                        row_stride: fan,
                        column_stride: 1,
                    };
                    let gradient = StridedMatrix {
                        numbers: &gradient.data[task.rows.start * size[0]..],
                        rows: self.shape.to,
                        columns,
                        row_stride: plane,
                        column_stride: 1,
                    };
                    multiply(weight.transposed(), gradient, memory);
                    let channels = band.chunks_exact_mut(rows.len() * read[0]);
                    for (of, band) in memory.chunks_exact(under * columns).zip(channels) {
                        self.scatter(of, size[0], &task.rows, band, &rows, read[0]);
                    }
                });
                band
            })
            .collect();
        let mut output = Maps::zeros(self.shape.from, read);
        let plane = output.plane();
        let each = output.data.par_chunks_exact_mut(plane).enumerate();
        each.for_each(|(channel, numbers)| {
            for (task, band) in tasks.iter().zip(&bands) {
                if !task.channels.contains(&channel) {
                    continue;
                }
                let rows = reach(task);
                let length = rows.len() * read[0];
                let from = &band[(channel - task.channels.start) * length..][..length];
                let into = &mut numbers[rows.start * read[0]..][..length];
                for (into, number) in into.iter_mut().zip(from) {
                    *into += number;
                }
            }
        });
        output
    }

    /// Columns of what it reads for some rows of what it writes, of the size `size`.
    fn gather(&self, input: &Maps, size: [usize; 2], rows: &Range<usize>, columns: &mut [f32]) {
        let ConvolutionShape { window, stride, .. } = self.shape;
        let [width, height] = input.size;
        let mut of_rows = columns.chunks_exact_mut(size[0]);
        for plane in input.data.chunks_exact(width * height) {
            for (down, across) in (0..window).flat_map(|y| (0..window).map(move |x| (y, x))) {
                let [out, from] = self.overlap(size[0], width, across);
                for (y, into) in rows.clone().zip(of_rows.by_ref()) {
                    // Above the first row and below the last one are zeros.
                    let row = (stride * y + down).checked_sub(self.shape.pad);
                    let Some(row) = row.filter(|&row| row < height) else {
                        into.fill(0.0);
                        continue;
                    };
                    into[..out.start].fill(0.0);
                    let numbers = &plane[row * width..][from.clone()];
                    if stride == 1 {
                        into[out.clone()].copy_from_slice(numbers);
                    } else {
                        let numbers = numbers.iter().step_by(stride);
                        for (into, number) in into[out.clone()].iter_mut().zip(numbers) {
                            *into = *number;
                        }
                    }
                    into[out.end..].fill(0.0);
                }
            }
        }
    }

    /// Adds the columns of a channel to rows of what it read.
    fn scatter(
        &self,
        columns: &[f32],
        written: usize,
        rows: &Range<usize>,
        band: &mut [f32],
        reach: &Range<usize>,
        width: usize,
    ) {
        let ConvolutionShape { window, stride, .. } = self.shape;
        let mut of_rows = columns.chunks_exact(written);
        for (down, across) in (0..window).flat_map(|y| (0..window).map(move |x| (y, x))) {
            let [out, from] = self.overlap(written, width, across);
            for (y, numbers) in rows.clone().zip(of_rows.by_ref()) {
                let row = (stride * y + down).checked_sub(self.shape.pad);
                let Some(row) = row.filter(|row| reach.contains(row)) else {
                    continue;
                };
                let into = &mut band[(row - reach.start) * width..][from.clone()];
                let numbers = &numbers[out.clone()];
                if stride == 1 {
                    for (into, number) in into.iter_mut().zip(numbers) {
                        *into += number;
                    }
                } else {
                    for (into, number) in into.iter_mut().step_by(stride).zip(numbers) {
                        *into += number;
                    }
                }
            }
        }
    }

    /// The pixels of a row that is written under which a number of the window lies in the row that
    /// is read, and the pixels there from the first such to the last.
    fn overlap(&self, written: usize, read: usize, across: usize) -> [Range<usize>; 2] {
        let ConvolutionShape { pad, stride, .. } = self.shape;
        let start = pad.saturating_sub(across).div_ceil(stride).min(written);
        let end = (read + pad).saturating_sub(across).div_ceil(stride);
        let end = end.clamp(start, written);
        let first = (stride * start + across).saturating_sub(pad);
        let count = end - start;
        [
            start..end,
            first..first + (stride * count).saturating_sub(stride - 1),
        ]
    }
}

/// Runs something with numbers that the thread keeps; what is in them is left from before.
fn with_memory(count: usize, run: impl FnOnce(&mut [f32])) {
    let mut memory = COLUMN_MEMORY.take();
    if memory.len() < count {
        memory.resize(count, 0.0);
    }
    run(&mut memory[..count]);
    COLUMN_MEMORY.set(memory);
}
