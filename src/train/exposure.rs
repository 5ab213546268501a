//! Exposure and white balance of each camera: three gains, learned with the avatar.

use crate::adam::{Adam, Moments};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// The gains of all cameras, as logarithms, and Adam's moments of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exposure {
    log_gain: Vec<[f64; 3]>,
    moments: Moments,
}

impl Exposure {
    /// Gains of 1.
    pub fn new(cameras: usize) -> Self {
        Self {
            log_gain: vec![[0.0; 3]; cameras],
            moments: Moments::new(cameras, 3),
        }
    }

    /// All numbers that a step changes.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let gains = self.log_gain.iter().flatten().copied();
        gains.chain(self.moments.numbers())
    }

    /// How many cameras it is of.
    pub fn cameras(&self) -> usize {
        self.log_gain.len()
    }

    /// A camera's gains, RGB.
    pub fn gain(&self, camera: usize) -> DVec3 {
        DVec3::from(self.log_gain[camera]).exp()
    }

    /// A step of Adam for a camera. `gradient`: of the loss with respect to its gains.
    pub fn learn(&mut self, camera: usize, gradient: [f64; 3], rate: f64, adam: &Adam) {
        let gain = self.gain(camera);
        let of: [f64; 3] = std::array::from_fn(|c| gradient[c] * gain[c]);
        let change = self.moments.direction(camera, &of, 0.0, adam);
        for (own, change) in self.log_gain[camera].iter_mut().zip(change) {
            *own -= rate * change;
        }
    }

    /// Makes the mean of the logarithms 0, over all cameras that learn: a gain of all is a colour of
    /// the avatar.
    pub fn center(&mut self) {
        let learned: Vec<usize> = (0..self.cameras())
            .filter(|&camera| self.moments.updates(camera) > 0)
            .collect();
        for c in 0..3 {
            let sum: f64 = learned.iter().map(|&camera| self.log_gain[camera][c]).sum();
            let mean = sum / learned.len().max(1) as f64;
            for &camera in &learned {
                self.log_gain[camera][c] -= mean;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gains_are_found_up_to_one_that_all_share() {
        let truth = [[1.2, 1.0, 0.9], [0.8, 1.0, 1.1], [1.0, 1.0, 1.0]];
        // The last is held out.
        let mut exposure = Exposure::new(4);
        for step in 0..3000 {
            let camera = step % 3;
            let gain = exposure.gain(camera);
            // Of (gain − truth)² / 2.
            let gradient = std::array::from_fn(|c| gain[c] - truth[camera][c]);
            exposure.learn(camera, gradient, 0.005, &Adam::DEFAULT);
            exposure.center();
        }
        let ratio = exposure.gain(0) / exposure.gain(1);
        assert!(
            ratio.distance(DVec3::new(1.5, 1.0, 0.9 / 1.1)) < 0.05,
            "{ratio}"
        );
        let product = exposure.gain(0) * exposure.gain(1) * exposure.gain(2);
        assert!(product.distance(DVec3::ONE) < 1e-9);
        assert_eq!(exposure.gain(3), DVec3::ONE);
    }
}
