//! The perceptual loss of a part of a view, with its derivative.

use crate::gpu::{AskedPart, ImageLossMemory, StepLosses, StepOptions, Trainer};
use crate::recipe::{PerceptualKind, PerceptualOptions};
use crate::view::{Shows, TrainingView};
use effigy_core::random::Random;
use effigy_perceptual::{Graded, Network, Perceptual, PerceptualError, Planes, dssim_and_gradient};
use effigy_render::vulkan::{Error as GpuError, Gpu};
use std::path::Path;
use std::sync::atomic::AtomicBool;

/// The perceptual loss of views.
pub struct PerceptualLoss {
    network: Option<Perceptual>,
    options: PerceptualOptions,
    seed: u64,
}

/// The perceptual loss of a view.
pub struct PerceptualTerm {
    /// Its value, before the weight.
    pub value: f64,
    /// Derivative of the weighted loss with respect to each pixel of the view, RGB.
    pub gradient: Vec<[f32; 3]>,
}

/// What a step with the loss found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerceptualStep {
    /// The other losses.
    pub losses: StepLosses,
    /// The loss's mean over the views, before its weight.
    pub value: f64,
}

/// A part of a view: its first column and row, and its sides, px.
struct ImageWindow {
    first: [usize; 2],
    size: [usize; 2],
}

impl PerceptualLoss {
    /// The loss that the options name, or None where they name none. `weights`: the folder that
    /// `tools/fetch_perceptual.sh` fills, and in which the user puts torchvision's file for LPIPS.
    ///
    /// # Errors
    /// When the weights are not there, are others, or this machine computes wrongly with them.
    pub fn new(
        options: &PerceptualOptions,
        weights: &Path,
        seed: u64,
    ) -> Result<Option<Self>, PerceptualError> {
        let network = match options.kind {
            PerceptualKind::None => return Ok(None),
            PerceptualKind::Dssim => None,
            PerceptualKind::StLpipsAlex => Some(Network::Alex),
            PerceptualKind::StLpipsVgg => Some(Network::Vgg),
            PerceptualKind::LpipsAlex => Some(Network::LpipsAlex),
            PerceptualKind::LpipsVgg => Some(Network::LpipsVgg),
        };
        let network = match network {
            Some(network) => {
                let read = Perceptual::read(network, weights)?;
                read.check()?;
                Some(read)
            }
            None => None,
        };
        Ok(Some(Self::with_network(network, options, seed)))
    }

    /// The loss of a network whatever its weights, which are not checked; None: D-SSIM.
    pub fn with_network(
        network: Option<Perceptual>,
        options: &PerceptualOptions,
        seed: u64,
    ) -> Self {
        Self {
            network,
            options: options.clone(),
            seed,
        }
    }

    /// Compares a part of an image with the same part of a view's picture. `image`: RGB of every
    /// pixel over the view's background; `place`: of the view in the training, which decides the
    /// part. None where the view shows nobody.
    pub fn compare(
        &self,
        view: &TrainingView,
        place: u64,
        image: &[[f32; 3]],
    ) -> Option<PerceptualTerm> {
        let window = self.window(view, place)?;
        let width = view.picture.size[0] as usize;
        let at = |x: usize, y: usize| (window.first[1] + y) * width + window.first[0] + x;
        let [columns, rows] = window.size;
        let mut drawn = Planes::black(window.size);
        let mut truth = Planes::black(window.size);
        for y in 0..rows {
            for x in 0..columns {
                let pixel = at(x, y);
                let own = image[pixel];
                let shown = match view.picture.shows(pixel) {
                    // As the image has it: no difference, no derivative of its own.
                    Shows::Unknown => own,
                    _ => view.picture.color(pixel).as_vec3().to_array(),
                };
                for c in 0..3 {
                    drawn.data[(c * rows + y) * columns + x] = own[c];
                    truth.data[(c * rows + y) * columns + x] = shown[c];
                }
            }
        }
        let Graded { value, gradient } = match &self.network {
            Some(network) => network.value_and_gradient(&drawn, &network.features(&truth)),
            None => dssim_and_gradient(&drawn, &truth),
        };
        let weight = self.weight(view) as f32;
        let mut of_image = vec![[0.0; 3]; image.len()];
        for y in 0..rows {
            for x in 0..columns {
                let pixel = at(x, y);
                if view.picture.shows(pixel) != Shows::Unknown {
                    of_image[pixel] = std::array::from_fn(|c| {
                        weight * gradient.data[(c * rows + y) * columns + x]
                    });
                }
            }
        }
        Some(PerceptualTerm {
            value,
            gradient: of_image,
        })
    }

    /// The weight of the loss of a part of a view. The part stands for the view, and what is cut away
    /// around it shows nobody: the mean over the whole picture, as of L1.
    fn weight(&self, view: &TrainingView) -> f64 {
        let of_whole = view.picture.pixels.len() as f64 / view.whole as f64;
        self.options.weight * self.options.every as f64 * of_whole
    }

    /// The part of a view that [`Self::compare`] looks at, and its weight.
    fn part(&self, view: &TrainingView, place: u64) -> Option<AskedPart> {
        let window = self.window(view, place)?;
        Some(AskedPart {
            first: window.first.map(|at| at as u32),
            weight: self.weight(view),
        })
    }

    /// The size of parts of views, px.
    fn part_size(&self, view: [u32; 2]) -> [usize; 2] {
        view.map(|side| side.min(self.options.window) as usize)
    }

    fn needs(&self, view: [u32; 2], views: usize) -> ImageLossMemory {
        let network = self.network.as_ref().map(Perceptual::network);
        ImageLossMemory::new(network, self.part_size(view), views)
    }

    /// Device memory that the loss takes where the device works it out, bytes. `view`: the size of
    /// views, px; `views`: of a step.
    pub fn memory(&self, view: [u32; 2], views: usize) -> u64 {
        self.needs(view, views).bytes
    }

    /// Whether a device should work out the loss. On CPU drivers the CPU's networks are faster
    /// (docs/experiments/076), and some devices' buffers are too small for feature maps.
    pub fn suits(&self, gpu: &Gpu, view: [u32; 2], views: usize) -> bool {
        let limit = u64::from(gpu.probe.limits.max_storage_buffer_range);
        !gpu.probe.is_cpu() && self.needs(view, views).largest <= limit
    }

    /// Hands the loss over to the trainer's device. `view`: the size of views.
    ///
    /// # Errors
    /// When the device has too little memory.
    pub fn hand_over(&self, trainer: &mut Trainer, view: [u32; 2]) -> Result<(), GpuError> {
        trainer.add_image_loss(self.network.as_ref(), self.part_size(view))
    }

    /// A step with the loss. Where it was handed over, the step is one submission; otherwise the
    /// CPU compares each view's image in between. `place`: of the first view in the training. None
    /// where `stop` was set before its end: nothing is learned then.
    ///
    /// # Panics
    /// Where [`Trainer::step`] does.
    pub fn step(
        &self,
        trainer: &mut Trainer,
        views: &[TrainingView],
        options: &StepOptions,
        place: u64,
        stop: &AtomicBool,
    ) -> Result<Option<PerceptualStep>, GpuError> {
        let mut value = 0.0;
        let losses = if trainer.has_image_loss() {
            let parts = (place..).zip(views);
            let parts: Vec<Option<AskedPart>> =
                parts.map(|(place, view)| self.part(view, place)).collect();
            let losses = trainer.step_with_parts(views, options, &parts)?;
            for (number, _) in parts.iter().enumerate().filter(|(_, part)| part.is_some()) {
                value += trainer.part_loss(number);
            }
            Some(losses)
        } else {
            trainer.step_with_image_loss(views, options, stop, |number, image| {
                let term = self.compare(&views[number], place + number as u64, image)?;
                value += term.value;
                Some(term.gradient)
            })?
        };
        Ok(losses.map(|losses| PerceptualStep {
            losses,
            value: value / views.len() as f64,
        }))
    }

    /// A part around a pixel of the person, as near to it as the view allows.
    fn window(&self, view: &TrainingView, place: u64) -> Option<ImageWindow> {
        let people: Vec<usize> = (0..view.picture.pixels.len())
            .filter(|&pixel| view.picture.shows(pixel) == Shows::Person)
            .collect();
        let mut random = Random::new(self.seed ^ 0xA5CE_D105, place);
        let middle = *people.get((random.uniform() * people.len() as f64) as usize)?;
        let sides = view.picture.size.map(|side| side as usize);
        let size = self.part_size(view.picture.size);
        let middle = [middle % sides[0], middle / sides[0]];
        let first = std::array::from_fn(|axis| {
            let low = middle[axis].saturating_sub(size[axis] / 2);
            low.min(sides[axis] - size[axis])
        });
        Some(ImageWindow { first, size })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::ViewPicture;
    use effigy_core::scene::Camera;
    use glam::DVec3;
    use std::sync::Arc;

    #[test]
    fn it_is_the_slope_of_the_weighted_loss_and_none_where_nobody_is() {
        let size = [40, 50];
        let count = 2000;
        let mut random = Random::new(3, 0);
        let options = PerceptualOptions {
            kind: PerceptualKind::Dssim,
            weight: 0.1,
            every: 4,
            window: 32,
            from_share: 0.0,
        };
        let perceptual = PerceptualLoss::new(&options, Path::new(""), 1)
            .unwrap()
            .unwrap();
        let mut view = TrainingView {
            joints: vec![],
            input: vec![],
            camera: Camera::look_at(DVec3::Z, DVec3::ZERO, 0.5, size),
            gain: DVec3::ONE,
            whole: count,
            picture: Arc::new(ViewPicture {
                size,
                pixels: (0..count)
                    .map(|at| {
                        let shows = [0, 85, 170, 255][at as usize % 4];
                        [(random.bits() >> 56) as u8, 90, (at % 250) as u8, shows]
                    })
                    .collect(),
                behind: vec![[77; 4]; count as usize],
            }),
        };
        let image: Vec<[f32; 3]> = (0..count)
            .map(|_| [random.uniform() as f32, 0.4, random.uniform() as f32])
            .collect();
        let found = perceptual.compare(&view, 7, &image).unwrap();
        assert!(found.gradient.iter().flatten().all(|v| v.is_finite()));
        let direction: Vec<[f32; 3]> = (0..count)
            .map(|at| {
                let sure = view.picture.shows(at as usize) != Shows::Unknown;
                [0; 3].map(|_| if sure { random.normal() as f32 } else { 0.0 })
            })
            .collect();
        let along = |h: f32| {
            let moved: Vec<[f32; 3]> = image
                .iter()
                .zip(&direction)
                .map(|(v, d)| std::array::from_fn(|c| v[c] + h * d[c]))
                .collect();
            perceptual.compare(&view, 7, &moved).unwrap().value
        };
        let expected = 0.1 * 4.0 * (along(2e-3) - along(-2e-3)) / 4e-3;
        let slope: f64 = found
            .gradient
            .iter()
            .zip(&direction)
            .map(|(g, d)| (0..3).map(|c| f64::from(g[c] * d[c])).sum::<f64>())
            .sum();
        assert!(
            (slope - expected).abs() < 0.02 * expected.abs(),
            "{slope}, expected {expected}"
        );
        view.picture = Arc::new(ViewPicture {
            size,
            pixels: vec![[0; 4]; count as usize],
            behind: vec![[0; 4]; count as usize],
        });
        assert!(perceptual.compare(&view, 7, &image).is_none());
    }
}
