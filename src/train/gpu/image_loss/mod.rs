//! A loss of a part of each view, on the device: D-SSIM, or the distance of a network.
//!
//! The kernels are those of `shaders/perceptual`. One view comes after the other, in the same memory.

pub mod convolution;
mod dssim;
mod network;
pub mod operation;
mod plan;
mod steps;

use super::arrays::read;
use super::buffers::{Batch, TrainerBuffers, groups};
use super::shaders;
use effigy_perceptual::{Network, Perceptual};
use effigy_render::vulkan::compute::{
    Buffer, Kernel, Launch, Module, Recording, Resources, Scope, Slice,
};
use effigy_render::vulkan::{Gpu, Result};
use plan::NetworkPlan;
use std::sync::Arc;
use steps::LossSteps;

/// A loss of a part of a view.
#[derive(Clone, Copy, Debug)]
pub struct AskedPart {
    /// First column and row, px.
    pub first: [u32; 2],
    /// The loss's weight.
    pub weight: f64,
}

/// The loss of parts of one size.
pub(super) struct ImageLoss {
    // Kernels go before what they are bound to.
    crop: Kernel,
    asked: Kernel,
    steps: LossSteps,
    /// Of all views.
    view_sums: Buffer,
    /// Width and height of a part, px.
    pub size: [usize; 2],
}

/// Device memory of the loss of a network or of D-SSIM, bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ImageLossMemory {
    /// All of it.
    pub bytes: u64,
    /// The largest buffer.
    pub largest: u64,
}

impl ImageLossMemory {
    /// `network`: None for D-SSIM; `size`: of a part, px; `views`: of a step.
    pub fn new(network: Option<Network>, size: [usize; 2], views: usize) -> Self {
        let sums = |count: usize| 4 * (views * count) as u64;
        match network {
            Some(network) => {
                let plan = NetworkPlan::new(network, size);
                Self {
                    bytes: plan.bytes() + sums(plan.sums()),
                    largest: plan.largest(),
                }
            }
            None => {
                let buffers = dssim::buffers(size).map(|words| 4 * words as u64);
                Self {
                    bytes: buffers.iter().sum::<u64>() + sums(dssim::buffers(size)[3]),
                    largest: buffers.into_iter().max().unwrap_or(0),
                }
            }
        }
    }
}

impl ImageLoss {
    pub fn new(
        gpu: &Arc<Gpu>,
        buffers: &TrainerBuffers,
        batch: Batch,
        network: Option<&Perceptual>,
        size: [usize; 2],
    ) -> Result<Self> {
        let steps = match network {
            Some(network) => network::steps(gpu, network, size)?,
            None => dssim::steps(gpu, size)?,
        };
        let view_sums = read(gpu, "views' distance sums", steps.sum_count * batch.views)?;
        let kernel = |module: &'static Module, constants: &[u32], storage: &[Slice]| {
            let resources = Resources {
                uniform: Some(buffers.view.uniform()),
                storage,
                image: None,
            };
            Kernel::new(gpu, module, constants, resources, Launch::default())
        };
        let pictures = (&buffers.inputs.pictures).into();
        let color = steps.color;
        let factor = color.factor.map(f32::to_bits);
        let crop = kernel(
            &shaders::CROP,
            &[factor, color.offset.map(f32::to_bits)].concat(),
            &[
                (&buffers.view.image).into(),
                pictures,
                (&buffers.inputs.behind).into(),
                steps.pair,
            ],
        )?;
        let asked = kernel(
            &shaders::ASKED,
            &[&factor[..], &[steps.sum_count as u32]].concat(),
            &[
                pictures,
                steps.gradient,
                (&steps.sums).into(),
                (&buffers.view.asked).into(),
                (&view_sums).into(),
            ],
        )?;
        Ok(Self {
            crop,
            asked,
            steps,
            view_sums,
            size,
        })
    }

    /// From a view's image to what is asked of it. `offset`: of the view's block.
    pub fn record(&self, commands: Recording, offset: u32, pixels: usize) {
        let next = || commands.barrier(Scope::KERNEL, Scope::KERNEL);
        let part = groups(self.size[0] * self.size[1]);
        self.crop.dispatch(commands, offset, part);
        next();
        for operation in &self.steps.operations {
            operation.record(commands);
        }
        let all = groups(pixels.max(self.steps.sum_count));
        self.asked.dispatch(commands, offset, all);
        next();
    }

    /// The loss of a view of the last step that asked for it, before its weight.
    pub fn value(&mut self, view: usize) -> f64 {
        let count = self.steps.sum_count;
        let bytes = &self.view_sums.mapped()[4 * view * count..][..4 * count];
        let sums: &[f32] = bytemuck::cast_slice(bytes);
        sums.iter().map(|&sum| f64::from(sum)).sum()
    }
}
