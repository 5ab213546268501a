//! The quality that can be given up to hold a frame rate, and in which order: a promised rate goes
//! in, rungs come out.

use effigy_core::scene::Detail;

/// Motion at this rate or above looks smooth, frames a second. From 1.5 times this rate on, holding
/// a pose for two frames is one of the first steps.
const SMOOTH: f64 = 60.0;
/// Images at a lower rate are no longer seen as motion, frames a second: the display's rate is not
/// halved to below this.
const MOVING: f64 = 24.0;

/// How much of the full quality a frame is drawn with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameQuality {
    /// Sides of the rendered image, as a share of the full size, above 0 and up to 1.
    pub scale: f64,
    /// Frames that each pose is held for, at least 1.
    pub hold: u32,
    /// By how many levels small avatars are drawn coarser than is near enough.
    pub coarser: usize,
    /// The finest level of detail that may be drawn; 0 is full detail.
    pub level: u32,
    /// Refreshes of the display that each frame is shown for, at least 1.
    pub refreshes: u32,
}

impl FrameQuality {
    /// Nothing is given up.
    pub const FULL: Self = Self {
        scale: 1.0,
        hold: 1,
        coarser: 0,
        level: 0,
        refreshes: 1,
    };

    /// Width and height to render at, px, for an image of `full_size`.
    pub fn size(&self, full_size: [u32; 2]) -> [u32; 2] {
        full_size.map(|side| ((f64::from(side) * self.scale).round() as u32).max(1))
    }

    /// The level of detail to draw with, from that of full quality.
    pub fn detail(&self, full: Detail) -> Detail {
        Detail {
            coarser: full.coarser + self.coarser,
            ..full.at_least(self.level)
        }
    }
}

/// A step of the ladder.
#[derive(Clone, Debug, PartialEq)]
pub struct Rung {
    /// The quality that this step gives up, in a few words.
    pub name: String,
    /// The quality that is left.
    pub quality: FrameQuality,
    /// Expected work a second, as a share of that at full quality.
    pub cost: f64,
}

/// Rungs from full quality down, on two paths: that of large avatars, and that of small ones, which
/// are drawn as if they were 720 px. A smaller image saves next to nothing of those, and a coarser
/// level more than half (docs/experiments/057).
#[derive(Clone, Debug, PartialEq)]
pub struct Ladder {
    /// Full quality, the other rungs for large avatars, then those for small ones.
    rungs: Vec<Rung>,
    /// Index of the first for small avatars.
    small: usize,
}

impl Ladder {
    /// The ladder for a promised rate, frames a second.
    pub fn new(rate: f64) -> Self {
        // Each list ends with halving the display's rate.
        const FOR_SMALL: &[Concession] = &[
            Concession::Coarser(1),
            Concession::Hold,
            Concession::Coarser(2),
            Concession::Refresh,
        ];
        const FOR_HIGH_RATES: &[Concession] = &[
            Concession::Scale(0.9),
            Concession::Scale(0.8),
            Concession::Hold,
            Concession::Scale(0.7),
            Concession::Scale(0.6),
            Concession::Level(1),
            Concession::Scale(0.5),
            Concession::Refresh,
        ];
        const FOR_OTHER_RATES: &[Concession] = &[
            Concession::Scale(0.9),
            Concession::Scale(0.8),
            Concession::Scale(0.7),
            Concession::Scale(0.6),
            Concession::Level(1),
            Concession::Scale(0.5),
            Concession::Hold,
            Concession::Refresh,
        ];
        let for_large = if rate >= 1.5 * SMOOTH {
            FOR_HIGH_RATES
        } else {
            FOR_OTHER_RATES
        };
        let mut rungs = vec![Rung {
            name: "full".into(),
            quality: FrameQuality::FULL,
            cost: 1.0,
        }];
        let mut small = 0;
        for concessions in [for_large, FOR_SMALL] {
            let count = if rate >= 2.0 * MOVING {
                concessions.len()
            } else {
                concessions.len() - 1
            };
            small = rungs.len();
            let mut quality = FrameQuality::FULL;
            for concession in &concessions[..count] {
                concession.apply(&mut quality);
                rungs.push(Rung {
                    name: concession.name(rate),
                    quality,
                    cost: cost(&quality),
                });
            }
        }
        Self { rungs, small }
    }

    /// All rungs: full quality, those for large avatars, those for small ones.
    pub fn rungs(&self) -> &[Rung] {
        &self.rungs
    }

    /// Index of the rung so many steps down a path; 0 is full quality, which both begin with.
    pub fn rung(&self, small: bool, step: usize) -> usize {
        if small && step > 0 {
            self.small + step - 1
        } else {
            step
        }
    }

    /// Indices of the rungs of a path, full quality first. There is at least one more.
    pub fn path(&self, small: bool) -> Vec<usize> {
        let below = if small {
            self.rungs.len() - self.small
        } else {
            self.small - 1
        };
        (0..=below).map(|step| self.rung(small, step)).collect()
    }
}

/// The quality that one step of a ladder gives up.
#[derive(Clone, Copy)]
enum Concession {
    /// Draws at this scale.
    Scale(f64),
    /// Holds each pose for two frames.
    Hold,
    /// Draws small avatars from a level that is coarser by so many than what is near enough.
    Coarser(usize),
    /// Draws at this level of detail or a coarser one.
    Level(u32),
    /// Shows each frame for two refreshes.
    Refresh,
}

impl Concession {
    fn apply(self, quality: &mut FrameQuality) {
        match self {
            Self::Scale(scale) => quality.scale = scale,
            Self::Hold => quality.hold = 2,
            Self::Coarser(levels) => quality.coarser = levels,
            Self::Level(level) => quality.level = level,
            Self::Refresh => {
                quality.refreshes = 2;
                // A pose that was held for two refreshes is now held for one frame.
                quality.hold = 1;
            }
        }
    }

    fn name(self, rate: f64) -> String {
        match self {
            Self::Scale(scale) => format!("scale {scale}"),
            Self::Hold => format!("pose {:.0} Hz", rate / 2.0),
            Self::Coarser(levels) => format!("{levels} coarser"),
            Self::Level(level) => format!("detail {}", Detail::FULL.at_least(level)),
            Self::Refresh => format!("display {:.0} Hz", rate / 2.0),
        }
    }
}

/// Expected work a second of a quality, as a share of that at full quality.
///
/// Pixels cost three quarters of a frame, Gaussians and networks the rest (2048² against 1024², see
/// docs/benchmarks.md). Holding a pose saves the frame where the camera is still, and its networks
/// where it moves. Drawing half of the Gaussians saves 0.3 of a frame (docs/experiments/015), and
/// nothing where the avatar is so small that no more of them are drawn anyway. A coarser level of
/// the file has a quarter of the Gaussians, and takes 0.4 of the time where it is all that is drawn
/// (docs/experiments/057).
fn cost(quality: &FrameQuality) -> f64 {
    let thin = 0.72f64.powi(quality.level as i32);
    let pixels = thin * (0.25 + 0.75 * quality.scale * quality.scale);
    let held = if quality.hold > 1 { 0.75 } else { 1.0 };
    let coarser = 0.45f64.powi(quality.coarser as i32);
    pixels * coarser * held / f64::from(quality.refreshes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rung_costs_less_than_the_one_above() {
        let rates = [5.0, 24.0, 48.0, 60.0, 90.0, 120.0, 144.0];
        for (rate, small) in rates
            .into_iter()
            .flat_map(|rate| [(rate, false), (rate, true)])
        {
            let ladder = Ladder::new(rate);
            let path: Vec<&Rung> = ladder
                .path(small)
                .into_iter()
                .map(|rung| &ladder.rungs()[rung])
                .collect();
            assert_eq!(ladder.rungs()[0].quality, FrameQuality::FULL);
            for pair in path.windows(2) {
                assert!(
                    pair[1].cost < pair[0].cost && pair[1].quality != pair[0].quality,
                    "{rate}: {pair:?}"
                );
            }
            assert_eq!(
                path.last().map(|rung| rung.quality.refreshes),
                Some(if rate >= 48.0 { 2 } else { 1 })
            );
        }
    }

    #[test]
    fn sizes_are_at_least_a_pixel() {
        let low = FrameQuality {
            scale: 0.5,
            ..FrameQuality::FULL
        };
        assert_eq!(low.size([1, 801]), [1, 401]);
    }
}
