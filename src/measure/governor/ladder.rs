//! What can be given up to hold a frame rate, in the order in which it is: a promised rate goes in, rungs come out.

use crate::{frame::Detail, vulkan::RendererOptions};

/// Motion at this rate or above looks smooth: a pose may be held for two frames early on, frames a second.
const SMOOTH: f64 = 60.0;
/// Below this a picture is no longer seen as moving: the display's rate is not halved beneath it.
const MOVING: f64 = 24.0;

/// How much of everything is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Sides of the picture, as a share of the screen's.
    pub scale: f64,
    /// Frames that a pose is shown for.
    pub hold: u32,
    /// What the opacity cutoff is multiplied by: fainter Gaussians, and the faint rims of others, are left out.
    pub cutoff: f64,
    /// The level of detail that is drawn at least ([`Detail::least`]).
    pub level: u32,
    /// Refreshes of the display that a frame is shown for.
    pub refreshes: u32,
}

impl Quality {
    pub const FULL: Self = Self { scale: 1.0, hold: 1, cutoff: 1.0, level: 0, refreshes: 1 };

    /// Width and height of a picture for a screen, px.
    pub fn size(&self, screen: [u32; 2]) -> [u32; 2] {
        screen.map(|side| ((f64::from(side) * self.scale).round() as u32).max(1))
    }

    /// The cutoff that makes of the options' own, as [`RendererOptions::cutoff`].
    pub fn cutoff(&self, options: &RendererOptions) -> f64 {
        (options.cutoff * self.cutoff).min(1.0)
    }

    /// The level of detail that makes of the options' own.
    pub fn detail(&self, options: &RendererOptions) -> Detail {
        options.detail.at_least(self.level)
    }
}

/// A step of the ladder.
#[derive(Clone, Debug, PartialEq)]
pub struct Rung {
    /// What it gives up, in a few words.
    pub name: String,
    pub quality: Quality,
    /// Work a second, of the whole quality's: what is expected before anything was measured.
    pub cost: f64,
}

/// Rungs from the whole quality down. There is always one.
#[derive(Clone, Debug, PartialEq)]
pub struct Ladder(Vec<Rung>);

impl Ladder {
    /// For a promised rate, frames a second.
    pub fn new(rate: f64) -> Self {
        let early = rate >= 1.5 * SMOOTH;
        let steps: &[Step] = match (early, rate >= 2.0 * MOVING) {
            (true, _) => &[
                Step::Scale(0.9),
                Step::Scale(0.8),
                Step::Hold,
                Step::Scale(0.7),
                Step::Cutoff(2.0),
                Step::Scale(0.6),
                Step::Cutoff(4.0),
                Step::Level(1),
                Step::Scale(0.5),
                Step::Refresh,
            ],
            (false, moving) => {
                let all = &[
                    Step::Scale(0.9),
                    Step::Scale(0.8),
                    Step::Cutoff(2.0),
                    Step::Scale(0.7),
                    Step::Scale(0.6),
                    Step::Cutoff(4.0),
                    Step::Level(1),
                    Step::Scale(0.5),
                    Step::Hold,
                    Step::Refresh,
                ];
                if moving { all } else { &all[..9] }
            }
        };
        let mut quality = Quality::FULL;
        let mut rungs = vec![Rung { name: "full".into(), quality, cost: 1.0 }];
        for step in steps {
            step.apply(&mut quality);
            rungs.push(Rung { name: step.name(rate), quality, cost: cost(&quality) });
        }
        Self(rungs)
    }

    pub fn rungs(&self) -> &[Rung] {
        &self.0
    }

    /// Number of the last rung.
    pub fn lowest(&self) -> usize {
        self.0.len() - 1
    }
}

#[derive(Clone, Copy)]
enum Step {
    Scale(f64),
    Hold,
    Cutoff(f64),
    Level(u32),
    Refresh,
}

impl Step {
    fn apply(self, quality: &mut Quality) {
        match self {
            Self::Scale(scale) => quality.scale = scale,
            Self::Hold => quality.hold = 2,
            Self::Cutoff(factor) => quality.cutoff = factor,
            Self::Level(level) => quality.level = level,
            // A pose that is held for two refreshes is then held for one frame.
            Self::Refresh => (quality.refreshes, quality.hold) = (2, 1),
        }
    }

    fn name(self, rate: f64) -> String {
        match self {
            Self::Scale(scale) => format!("scale {scale}"),
            Self::Hold => format!("pose {:.0} Hz", rate / 2.0),
            Self::Cutoff(factor) => format!("cutoff {factor}/255"),
            Self::Level(level) => format!("detail {}", Detail::FULL.at_least(level)),
            Self::Refresh => format!("display {:.0} Hz", rate / 2.0),
        }
    }
}

/// Pixels cost three quarters of a frame and Gaussians, with the networks, the rest (README, 2048² against 1024²); a held pose
/// saves the frame where the camera is still and its networks where not. Half of the Gaussians save 0.3 of a frame (NOTES.md, "Level of
/// detail"), nothing where no more of them are drawn anyway.
fn cost(quality: &Quality) -> f64 {
    let thin = 0.72f64.powi(quality.level as i32);
    let pixels = thin * (0.25 + 0.75 * quality.scale * quality.scale);
    let faint = match quality.cutoff {
        c if c >= 4.0 => 0.85,
        c if c >= 2.0 => 0.94,
        _ => 1.0,
    };
    let held = if quality.hold > 1 { 0.75 } else { 1.0 };
    pixels * faint * held / f64::from(quality.refreshes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rung_costs_less_than_the_one_above() {
        for rate in [5.0, 24.0, 48.0, 60.0, 90.0, 120.0, 144.0] {
            let ladder = Ladder::new(rate);
            assert_eq!(ladder.rungs()[0].quality, Quality::FULL);
            for pair in ladder.rungs().windows(2) {
                assert!(pair[1].cost < pair[0].cost && pair[1].quality != pair[0].quality, "{rate}: {pair:?}");
            }
            assert_eq!(ladder.rungs().last().map(|rung| rung.quality.refreshes), Some(if rate >= 48.0 { 2 } else { 1 }));
        }
    }

    #[test]
    fn a_picture_has_a_pixel_at_least_and_a_cutoff_is_an_opacity() {
        let low = Quality { scale: 0.5, cutoff: 400.0, ..Quality::FULL };
        assert_eq!((low.size([1, 801]), low.cutoff(&RendererOptions::new([1, 1]))), ([1, 401], 1.0));
    }
}
