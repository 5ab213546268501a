//! Splats' centres in the image as fixed-point numbers: two of [`POSITION_BITS`] and one of four
//! grids, so that a splat whose centre is far outside the image can still cover some of it.

use super::gpu::{CENTER_GRID_BITS, POSITION_BITS};
use glam::DVec2;

/// Grids that a splat's centre may be on: its number takes two bits.
const GRIDS: i32 = 4;

/// The grids of splats' centres in an image. The finest reaches from minus the image's longer side
/// to twice that; each other is 2^[`CENTER_GRID_BITS`] times as coarse and reaches as much further.
/// A splat that shows in the image from there is so wide that its grid's steps don't.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CenterGrids {
    /// How far outside the image the finest grid reaches, px: the image's longer side.
    pub guard: f64,
    /// Steps of the finest grid in a pixel, a power of two.
    pub steps: f64,
}

impl CenterGrids {
    /// The grids of an image of a width and height, px.
    pub fn of(size: [u32; 2]) -> Self {
        let guard = f64::from(size[0].max(size[1]));
        let steps = f64::from((1 << POSITION_BITS) - 1) / (3.0 * guard);
        Self {
            guard,
            steps: steps.log2().floor().exp2(),
        }
    }

    /// How many times as coarse as the finest grid the one is that a centre is rounded to, px from
    /// the image's top left corner.
    pub fn coarseness(self, center: DVec2) -> f64 {
        let beyond = (-center).max(0.5 * center).max_element() / self.guard;
        (0..GRIDS - 1)
            .map(coarseness)
            .find(|&coarseness| beyond <= coarseness)
            .unwrap_or(coarseness(GRIDS - 1))
    }

    /// A centre as it is stored, px.
    pub fn round(self, center: DVec2) -> DVec2 {
        let coarseness = self.coarseness(center);
        let last = f64::from((1 << POSITION_BITS) - 1);
        let code = ((center / coarseness + self.guard) * self.steps).round();
        (code.clamp(DVec2::ZERO, DVec2::splat(last)) / self.steps - self.guard) * coarseness
    }

    /// The centre of a splat that is stored as these words, px.
    pub fn center(self, words: [u32; 4]) -> DVec2 {
        let code = |word: u32| f64::from(word & ((1 << POSITION_BITS) - 1));
        let code = DVec2::new(code(words[0]), code(words[1]));
        (code / self.steps - self.guard) * coarseness((words[1] >> 30) as i32)
    }
}

/// How many times as coarse as the finest a grid is.
fn coarseness(grid: i32) -> f64 {
    (f64::from(CENTER_GRID_BITS) * f64::from(grid)).exp2()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{constants::F16_MAX, random::Random};

    /// A Gaussian that shows by 1/255 at the image's nearest edge is off by less than half of that
    /// anywhere, wherever its centre lies: as far as f16 holds its axes.
    #[test]
    fn no_step_of_a_grid_shows() {
        let random = &mut Random::new(3, 0);
        for seed in 0..20_000 {
            let size = [1u32, 7, 64, 640, 2048, 16_384][seed % 6];
            let grids = CenterGrids::of([size, size.div_ceil(2)]);
            let distance = f64::from(size) * random.range(0.0, 22.0).exp2();
            let center = distance * DVec2::new(random.range(-1.0, 1.0), random.range(-1.0, 1.0));
            let nearest = center.clamp(DVec2::ZERO, DVec2::splat(f64::from(size)));
            let sigma = center.distance(nearest) / (2.0 * 255f64.ln()).sqrt();
            if sigma > F16_MAX || grids.coarseness(center) == 1.0 {
                continue;
            }
            let off = grids.round(center).distance(center);
            // The steepest slope of a Gaussian is e^−½ / σ.
            assert!(
                off / sigma * (-0.5f64).exp() < 0.5 / 255.0,
                "{center} in {size} px is off by {off} px, with {sigma} px of deviation"
            );
        }
    }
}
