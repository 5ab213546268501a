//! Which frames of a case are compared with each other for their flicker.

use super::{case::BenchCase, scene::TAKE};
use crate::flicker::{STEPS, Shown};

/// First frames of the pairs of a take: one late enough that the frames before it are of the same
/// take, and one near the take's end.
const STARTS: [usize; 2] = [2, 9];
/// Pairs of a zoom for each distance between frames, besides those around switches.
const ZOOM_PAIRS: usize = 10;

/// Two frames to compare.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FramePair {
    /// Index of the earlier frame.
    pub from: usize,
    /// Index of the later one.
    pub to: usize,
    /// For how many pairs of the run it stands.
    pub weight: f64,
}

/// The pairs to compare, by their first frame. `shown`: how each frame draws the avatar.
pub fn pairs(case: BenchCase, shown: &[Shown]) -> Vec<FramePair> {
    let mut pairs: Vec<FramePair> = STEPS
        .into_iter()
        .flat_map(|step| match case {
            BenchCase::Zoom => zoom_pairs(shown, step),
            _ => take_pairs(shown.len(), step),
        })
        .collect();
    pairs.sort_by_key(|pair| (pair.from, pair.to));
    pairs
}

/// Pairs of every take, from frames that are shared as far as possible: a reference's image takes
/// seconds.
fn take_pairs(frames: usize, step: usize) -> Vec<FramePair> {
    let mut pairs = Vec::new();
    for first in (0..frames).step_by(TAKE) {
        let length = TAKE.min(frames - first);
        let starts = if step == 1 {
            STARTS
        } else {
            [STARTS[0], STARTS[0] + 1]
        };
        let mut starts: Vec<usize> = starts
            .into_iter()
            .filter(|start| start + step < length)
            .collect();
        if starts.is_empty() && step < length {
            starts.push(length - 1 - step);
        }
        pairs.extend(starts.into_iter().map(|start| FramePair {
            from: first + start,
            to: first + start + step,
            weight: 1.0,
        }));
    }
    pairs
}

/// Pairs all along the way, and one around each switch. A switch stands for the pairs of the run
/// that have it between them, the others for all that have none.
fn zoom_pairs(shown: &[Shown], step: usize) -> Vec<FramePair> {
    let Some(all) = shown.len().checked_sub(step).filter(|&all| all > 0) else {
        return Vec::new();
    };
    let switches = |from: usize| {
        shown[from..=from + step]
            .windows(2)
            .any(|two| two[0].switches_to(&two[1]))
    };
    let mut pairs: Vec<FramePair> = Vec::new();
    for at in (1..shown.len()).filter(|&at| shown[at - 1].switches_to(&shown[at])) {
        let from = at.saturating_sub(step.div_ceil(2)).min(all - 1);
        if pairs.iter().all(|pair| pair.from != from) {
            pairs.push(FramePair {
                from,
                to: from + step,
                weight: step as f64,
            });
        }
    }
    let steady: Vec<usize> = (0..all)
        .step_by(all.div_ceil(ZOOM_PAIRS))
        .filter(|&from| !switches(from))
        .collect();
    let switching: f64 = pairs.iter().map(|pair| pair.weight).sum();
    let weight = (all as f64 - switching).max(0.0) / steady.len().max(1) as f64;
    pairs.extend(steady.into_iter().map(|from| FramePair {
        from,
        to: from + step,
        weight,
    }));
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(samples: f64) -> Shown {
        Shown {
            samples,
            gaussians: 100,
        }
    }

    #[test]
    fn takes_are_compared_within_themselves() {
        for frames in [1, 2, 3, 7, 8, 12, 13, 24, 31] {
            let pairs = pairs(BenchCase::Flicker, &vec![shown(1.0); frames]);
            for pair in &pairs {
                assert!(
                    pair.from < pair.to && pair.to < frames,
                    "{pair:?} of {frames}"
                );
                assert_eq!(pair.from / TAKE, pair.to / TAKE, "{pair:?}");
            }
            let has = |step| pairs.iter().any(|pair| pair.to - pair.from == step);
            assert_eq!(
                STEPS.map(has),
                STEPS.map(|step| frames > step),
                "{frames} frames"
            );
        }
        let mut frames: Vec<usize> = pairs(BenchCase::Flicker, &[shown(1.0); 24])
            .iter()
            .flat_map(|pair| [pair.from, pair.to])
            .collect();
        frames.sort_unstable();
        frames.dedup();
        assert_eq!(frames, [2, 3, 9, 10, 14, 15, 21, 22]);
    }

    #[test]
    fn a_zoom_has_a_pair_at_every_switch_and_counts_it_once() {
        let mut run = vec![shown(1.0); 200];
        let level = |samples: f64, gaussians| Shown { samples, gaussians };
        // More and more samples, which are no switch but where they begin; then other levels.
        for (at, own) in run.iter_mut().enumerate().skip(70) {
            *own = level(1.0 + 0.02 * (at - 69) as f64, 100);
        }
        run[120..].fill(level(4.0, 50));
        run[199] = level(4.0, 25);
        let pairs = pairs(BenchCase::Zoom, &run);
        for step in STEPS {
            let own: Vec<&FramePair> = pairs.iter().filter(|p| p.to - p.from == step).collect();
            for at in [70, 120, 199] {
                let around = own.iter().filter(|pair| pair.from < at && pair.to >= at);
                assert_eq!(around.count(), 1, "at {at}, {step} apart");
            }
            let weights: f64 = own.iter().map(|pair| pair.weight).sum();
            assert!((weights - (200 - step) as f64).abs() < 1e-9, "{weights}");
        }
        assert_eq!(super::pairs(BenchCase::Zoom, &run[..1]), []);
    }
}
