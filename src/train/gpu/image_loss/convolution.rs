//! Convolutions on a device, and their derivative with respect to what they read.

use super::super::arrays::filled;
use super::super::shaders;
use super::operation::{DeviceMaps, Operation};
use effigy_perceptual::convolution::Convolution;
use effigy_perceptual::network::ConvolutionShape;
use effigy_render::vulkan::compute::{Buffer, Slice};
use effigy_render::vulkan::{Gpu, Result};
use std::sync::Arc;

/// Most invocations of a workgroup, and most columns of them.
const INVOCATIONS: u32 = 128;
const LANES: u32 = 16;
/// Shared memory of a workgroup that leaves room for others beside it, bytes.
const SHARED: u32 = 8 << 10;

/// The weights of a convolution in a device's memory, as the kernel reads them forward and backward.
pub struct DeviceConvolution {
    shape: ConvolutionShape,
    forward: Buffer,
    backward: Buffer,
    biases: Buffer,
}

/// How the window moves over what is read.
struct Walk {
    from: usize,
    to: usize,
    window: usize,
    step: usize,
    divisor: usize,
    pad: usize,
}

/// What becomes of sums: `END` of `shaders/perceptual/convolve.comp`.
#[derive(Clone, Copy)]
enum End {
    Bare = 0,
    Bias = 1,
    BiasAndRectify = 2,
    Mask = 3,
}

/// Weights with four channels that are written beside each other. `weight`: of a channel that is
/// written, one that is read, and a place under the window.
fn quads([from, taps, to]: [usize; 3], weight: impl Fn(usize, usize, usize) -> f32) -> Vec<f32> {
    let padded = to.next_multiple_of(4);
    let mut all = vec![0.0; from * taps * padded];
    for (row, numbers) in all.chunks_exact_mut(padded).enumerate() {
        for (channel, number) in numbers[..to].iter_mut().enumerate() {
            *number = weight(channel, row / taps, row % taps);
        }
    }
    all
}

impl DeviceConvolution {
    /// Copies weights to a device, and waits.
    pub fn new(gpu: &Arc<Gpu>, convolution: &Convolution) -> Result<Self> {
        let shape = convolution.shape;
        let taps = shape.window * shape.window;
        let at = |to, from, tap| convolution.weight[to * shape.fan() + from * taps + tap];
        let forward = quads([shape.from, taps, shape.to], at);
        // The way back goes over the window from its end.
        let backward = quads([shape.to, taps, shape.from], |from, to, tap| {
            at(to, from, taps - 1 - tap)
        });
        Ok(Self {
            shape,
            forward: filled(gpu, "weights", &forward)?,
            backward: filled(gpu, "weights for the way back", &backward)?,
            biases: filled(gpu, "biases", &convolution.bias)?,
        })
    }

    /// Numbers of all of it, for a shape.
    pub fn words(shape: &ConvolutionShape) -> usize {
        let taps = shape.window * shape.window;
        let one = |from: usize, to: usize| from * taps * to.next_multiple_of(4);
        one(shape.from, shape.to) + one(shape.to, shape.from) + shape.to
    }

    /// [`Convolution::forward`].
    pub fn forward(
        &self,
        gpu: &Arc<Gpu>,
        read: DeviceMaps,
        written: DeviceMaps,
        rectifies: bool,
    ) -> Result<Operation> {
        let shape = self.shape;
        let walk = Walk {
            from: shape.from,
            to: shape.to,
            window: shape.window,
            step: shape.stride,
            divisor: 1,
            pad: shape.pad,
        };
        let end = if rectifies {
            End::BiasAndRectify
        } else {
            End::Bias
        };
        self.convolve(
            gpu,
            [read, written],
            walk,
            (&self.forward).into(),
            end,
            read.slice,
        )
    }

    /// [`Convolution::backward`]. `kept`: what it read, where that was rectified: the derivative is
    /// then that before.
    pub fn backward(
        &self,
        gpu: &Arc<Gpu>,
        of_written: DeviceMaps,
        of_read: DeviceMaps,
        kept: Option<Slice>,
    ) -> Result<Operation> {
        let shape = self.shape;
        let walk = Walk {
            from: shape.to,
            to: shape.from,
            window: shape.window,
            step: 1,
            divisor: shape.stride,
            pad: shape.window - 1 - shape.pad,
        };
        let end = kept.map_or(End::Bare, |_| End::Mask);
        let kept = kept.unwrap_or(of_written.slice);
        let both = [of_written, of_read];
        self.convolve(gpu, both, walk, (&self.backward).into(), end, kept)
    }

    fn convolve(
        &self,
        gpu: &Arc<Gpu>,
        [read, written]: [DeviceMaps; 2],
        walk: Walk,
        weights: Slice,
        end: End,
        kept: Slice,
    ) -> Result<Operation> {
        let numbers = |size: [usize; 2]| size.map(|side| side as u32);
        let ([a, b], [c, d]) = (numbers(read.size), numbers(written.size));
        // Few channels would leave most of a tile empty: a tile has more rows then. One of small
        // maps is no larger than it has to be.
        let [quads, groups] = if walk.to <= 4 { [1, 1] } else { [2, 8] };
        let lanes = (c.next_power_of_two() / 2).clamp(4, LANES);
        let rows = d.div_ceil(4).next_power_of_two();
        let rows = rows.min(INVOCATIONS / (lanes * groups));
        let tile = [2 * lanes, 4 * rows];
        let [step, window] = [walk.step as u32, walk.window as u32];
        let reach = tile.map(|side| (side - 1) * step + window);
        let at_once =
            SHARED.saturating_sub(4 * reach[0] * reach[1]) / (16 * window * quads * groups);
        let constants = [
            lanes * groups * rows,
            lanes,
            quads,
            groups,
            walk.from as u32,
            walk.to as u32,
            window,
            step,
            walk.divisor as u32,
            walk.pad as u32,
            a,
            b,
            c,
            d,
            at_once.clamp(1, window),
            end as u32,
        ];
        let biases = (&self.biases).into();
        let storage = [read.slice, weights, biases, written.slice, kept];
        let parts = (walk.to as u32).div_ceil(4).div_ceil(quads * groups);
        let dispatch = [
            c.div_ceil(tile[0]) * d.div_ceil(tile[1]),
            parts * written.pictures as u32,
        ];
        Operation::new(gpu, &shaders::CONVOLVE, &constants, &storage, dispatch)
    }
}
