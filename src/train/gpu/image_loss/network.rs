//! A network of ST-LPIPS or LPIPS on a device: the distance of a picture from its target, and its
//! derivative.

use super::super::arrays::{filled, words};
use super::convolution::DeviceConvolution;
use super::operation::{DeviceMaps, DistanceMemory, Operation};
use super::plan::{NetworkPlan, PlannedStep};
use super::steps::{ColorScale, LossSteps};
use effigy_perceptual::Perceptual;
use effigy_perceptual::head::{SCALE, SHIFT};
use effigy_perceptual::network::NetworkStep;
use effigy_render::vulkan::compute::{Buffer, Slice};
use effigy_render::vulkan::{Gpu, Result};
use std::sync::Arc;

/// What operations are made from.
struct Source<'a> {
    gpu: &'a Arc<Gpu>,
    plan: &'a NetworkPlan,
    /// Of maps that stay.
    own: Vec<Option<Buffer>>,
    slots: [Buffer; 2],
}

impl<'a> Source<'a> {
    fn new(gpu: &'a Arc<Gpu>, plan: &'a NetworkPlan) -> Result<Self> {
        let [a, b] = plan.slots();
        let own = plan.maps.iter().map(|maps| {
            let count = 2 * maps.channels * maps.size[0] * maps.size[1];
            let make = || words(gpu, "feature maps", count);
            maps.stays.then(make).transpose()
        });
        Ok(Self {
            gpu,
            plan,
            own: own.collect::<Result<_>>()?,
            slots: [
                words(gpu, "features' derivatives", a)?,
                words(gpu, "features' derivatives", b)?,
            ],
        })
    }

    /// The maps of an index, of both pictures.
    fn maps(&self, index: usize) -> DeviceMaps {
        let maps = self.plan.maps[index];
        DeviceMaps {
            slice: match &self.own[index] {
                Some(buffer) => buffer.into(),
                None => (&self.slots[NetworkPlan::slot(index)]).into(),
            },
            pictures: 2,
            channels: maps.channels,
            size: maps.size,
        }
    }

    /// The derivative with respect to those of the first picture.
    fn gradient(&self, index: usize) -> DeviceMaps {
        DeviceMaps {
            slice: (&self.slots[NetworkPlan::slot(index)]).into(),
            pictures: 1,
            ..self.maps(index)
        }
    }

    fn forward(
        &self,
        planned: &PlannedStep,
        weights: Option<&DeviceConvolution>,
    ) -> Result<Operation> {
        let (read, written) = (self.maps(planned.read), self.maps(planned.read + 1));
        let gpu = self.gpu;
        match (planned.step, weights) {
            (NetworkStep::Convolve(_), Some(weights)) => {
                weights.forward(gpu, read, written, planned.rectifies)
            }
            (NetworkStep::Pool(window), _) => Operation::pool(gpu, read, written, window),
            (NetworkStep::Thin(step), _) => Operation::thin(gpu, read, written, step),
            (NetworkStep::Blur, _) => Operation::blur(gpu, read, written, planned.rectifies),
            (NetworkStep::Convolve(_) | NetworkStep::Rectify, _) => {
                unreachable!("a plan has weights for convolutions, and no step that rectifies")
            }
        }
    }

    fn backward(
        &self,
        planned: &PlannedStep,
        weights: Option<&DeviceConvolution>,
    ) -> Result<Operation> {
        let of_written = self.gradient(planned.read + 1);
        let of_read = self.gradient(planned.read);
        let gpu = self.gpu;
        let slice = |index| self.maps(index).slice;
        match (planned.step, weights) {
            (NetworkStep::Convolve(_), Some(weights)) => {
                let kept = planned.masks.then(|| slice(planned.read));
                weights.backward(gpu, of_written, of_read, kept)
            }
            (NetworkStep::Pool(window), _) => {
                let forward = [slice(planned.read), slice(planned.read + 1)];
                Operation::pool_backward(gpu, of_written, of_read, forward, window)
            }
            (NetworkStep::Thin(step), _) => {
                Operation::thin_backward(gpu, of_written, of_read, step)
            }
            (NetworkStep::Blur, _) => Operation::blur_backward(gpu, of_written, of_read),
            (NetworkStep::Convolve(_) | NetworkStep::Rectify, _) => {
                unreachable!("a plan has weights for convolutions, and no step that rectifies")
            }
        }
    }
}

/// The distance of a network and its derivative, for pictures of a size.
pub(super) fn steps(
    gpu: &Arc<Gpu>,
    perceptual: &Perceptual,
    size: [usize; 2],
) -> Result<LossSteps> {
    let plan = NetworkPlan::new(perceptual.network(), size);
    let source = Source::new(gpu, &plan)?;
    let sums = words(gpu, "distance sums", plan.sums())?;
    let weights = perceptual.weights();
    let convolutions: Vec<DeviceConvolution> = (weights.convolutions.iter())
        .map(|own| DeviceConvolution::new(gpu, own))
        .collect::<Result<_>>()?;
    let heads: Vec<Buffer> = (weights.heads.iter())
        .map(|head| filled(gpu, "channels' weights", head))
        .collect::<Result<_>>()?;
    let convolves = |planned: &PlannedStep| matches!(planned.step, NetworkStep::Convolve(_));
    let mut operations = Vec::new();
    let mut ahead = convolutions.iter();
    for planned in &plan.steps {
        let own = convolves(planned).then(|| ahead.next()).flatten();
        operations.push(source.forward(planned, own)?);
    }
    let mut back = convolutions.iter().rev();
    for planned in plan.steps.iter().rev() {
        if let Some(layer) = planned.ends {
            let index = planned.read + 1;
            let memory = DistanceMemory {
                maps: source.maps(index),
                weights: (&heads[layer]).into(),
                gradient: source.gradient(index).slice,
                sums: (&sums).into(),
                first: plan.first_sums[layer],
            };
            // Nothing comes from behind the last layer.
            let adds = index + 1 < plan.maps.len();
            operations.push(Operation::distance(gpu, memory, adds)?);
        }
        let own = convolves(planned).then(|| back.next()).flatten();
        operations.push(source.backward(planned, own)?);
    }
    let factor = SCALE.map(|scale| 2.0 / scale);
    let pair: Slice = source.maps(0).slice;
    let gradient = source.gradient(0).slice;
    let mut kept: Vec<Buffer> = source.own.into_iter().flatten().collect();
    kept.extend(source.slots);
    kept.extend(heads);
    Ok(LossSteps {
        operations,
        pair,
        gradient,
        sums,
        sum_count: plan.sums(),
        color: ColorScale {
            factor,
            offset: std::array::from_fn(|c| (1.0 + SHIFT[c]) / SCALE[c]),
        },
        _buffers: kept,
        _convolutions: convolutions,
    })
}
