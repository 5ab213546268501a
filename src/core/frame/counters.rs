//! Counts of what a frame drew and skipped. They do not depend on how fast a device is.

use crate::layout::Control;
use serde::{Deserialize, Serialize};

/// Counts of one frame. Every Gaussian of the scene is either drawn or culled. In a frame that
/// draws nothing, all counts are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counters {
    /// Avatars in the scene.
    pub avatars: u64,
    /// Avatars all outside the view, for which no work was done.
    pub avatars_culled: u64,
    /// Gaussians of all avatars in the scene.
    pub gaussians: u64,
    /// Gaussians that the level of detail skips: part of `culled`.
    #[serde(alias = "thinned")]
    pub skipped_by_detail: u64,
    /// Avatars drawn larger than they are shown, then averaged.
    #[serde(default)]
    pub supersampled: u64,
    /// Samples a pixel along each axis, of the avatar with the most; 0 without avatars in view.
    #[serde(default)]
    pub most_samples: u64,
    /// The coarsest level that an avatar is drawn from; 0 is the avatar itself.
    #[serde(default)]
    pub coarsest_level: u64,
    /// Longest side of the box around the largest avatar in view, px of the image; 0
    /// without supersampling. Not a count: reports don't have it.
    #[serde(skip)]
    pub longest_side: u64,
    /// Pixels of the image that avatars are drawn into before they are averaged, gaps between them
    /// included. Reports don't have this one, nor the next two.
    #[serde(skip)]
    pub atlas: u64,
    /// Pixels that they are averaged into, those of each avatar's slot apart.
    #[serde(skip)]
    pub resolved: u64,
    /// Pixels that are averaged.
    #[serde(skip)]
    pub averaged: u64,
    /// Gaussians that were not drawn: those of culled avatars, those that the level of detail
    /// skips, and those culled one by one.
    pub culled: u64,
    /// Why Gaussians were culled one by one. None if that was not counted.
    pub reasons: Option<CullReasons>,
    /// Gaussians sorted and rasterized.
    pub drawn: u64,
    /// Networks that ran.
    pub networks: u64,
    /// Parts that are entirely outside the view.
    pub parts_outside: u64,
    /// Gaussians projected from the pose cache: all that an avatar's level of detail draws, or
    /// none.
    #[serde(alias = "kept")]
    pub cached: u64,
    /// With quads: fragment shader invocations; some drivers count only those that blend. With
    /// tiles: the pixels of all 4 × 4 squares that splats were put on. The two can't be compared.
    /// None if the device has no pipeline statistics.
    pub fragments: Option<u64>,
    /// With quads that are tested against the saturation depth: how often its samples evaluated a
    /// splat. None if that was not counted.
    #[serde(default)]
    pub samples: Option<u64>,
    /// Pixels that something was drawn into. None if they were not counted.
    pub covered: Option<u64>,
    /// Pixels of the damage rectangle, empty ones included.
    #[serde(alias = "area")]
    pub damaged: u64,
    /// Compute dispatches.
    pub dispatches: u64,
    /// Command buffers submitted: 0 for a frame that changes nothing.
    pub submitted: u64,
}

/// Gaussians culled one by one, each counted under the first reason that applies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CullReasons {
    /// Nearer than the near plane, or outside the image.
    pub outside: u64,
    /// Facing away from the camera.
    #[serde(default)]
    pub away: u64,
    /// Nowhere as opaque as the cutoff.
    pub faint: u64,
    /// Not finite, or beyond the range of f32.
    pub degenerate: u64,
}

impl CullReasons {
    /// How many there are.
    pub const COUNT: usize = 4;
    /// Bytes of their counts on a device, a word each, in the order of the fields
    /// (`shaders/project/culled.glsl`).
    pub const BYTES: u64 = 4 * Self::COUNT as u64;
}

impl Counters {
    /// These counts of a frame, with what the device counted. `reasons`: as the fields of
    /// [`CullReasons`].
    pub fn with_device_counts(
        self,
        control: &Control,
        reasons: Option<[u32; CullReasons::COUNT]>,
        fragments: Option<u64>,
        samples: Option<u64>,
    ) -> Self {
        let drawn = u64::from(control.visible_count);
        Self {
            culled: self.gaussians.saturating_sub(drawn),
            drawn,
            reasons: reasons.map(|counts| {
                let [outside, away, faint, degenerate] = counts.map(u64::from);
                CullReasons {
                    outside,
                    away,
                    faint,
                    degenerate,
                }
            }),
            fragments,
            samples,
            ..self
        }
    }

    /// Every count that is known, under its name in reports and JSON, in the order of tables.
    pub fn named(&self) -> impl Iterator<Item = (&'static str, u64)> {
        let all = [
            ("avatars", Some(self.avatars)),
            ("avatars_culled", Some(self.avatars_culled)),
            ("gaussians", Some(self.gaussians)),
            ("culled", Some(self.culled)),
            ("skipped_by_detail", Some(self.skipped_by_detail)),
            ("supersampled", Some(self.supersampled)),
            ("most_samples", Some(self.most_samples)),
            ("coarsest_level", Some(self.coarsest_level)),
            ("outside", self.reasons.map(|reasons| reasons.outside)),
            ("away", self.reasons.map(|reasons| reasons.away)),
            ("faint", self.reasons.map(|reasons| reasons.faint)),
            ("degenerate", self.reasons.map(|reasons| reasons.degenerate)),
            ("drawn", Some(self.drawn)),
            ("networks", Some(self.networks)),
            ("parts_outside", Some(self.parts_outside)),
            ("cached", Some(self.cached)),
            ("fragments", self.fragments),
            ("samples", self.samples),
            ("covered", self.covered),
            ("damaged", Some(self.damaged)),
            ("dispatches", Some(self.dispatches)),
            ("submitted", Some(self.submitted)),
        ];
        all.into_iter()
            .filter_map(|(name, count)| Some((name, count?)))
    }

    /// Fragments shaded for each covered pixel. None if either is unknown or nothing is covered.
    pub fn overdraw(&self) -> Option<f64> {
        let fragments = self.fragments?;
        let covered = self.covered?;
        (covered > 0).then(|| fragments as f64 / covered as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overdraw_needs_counts_and_covered_pixels() {
        let counted = Counters {
            fragments: Some(30),
            covered: Some(12),
            ..Counters::default()
        };
        assert_eq!(counted.overdraw(), Some(2.5));
        assert_eq!(counted.named().count(), 17);
        assert_eq!(
            Counters {
                reasons: Some(CullReasons::default()),
                ..counted
            }
            .named()
            .count(),
            21
        );
        assert_eq!(Counters::default().named().count(), 15);
        assert_eq!(
            Counters {
                covered: Some(0),
                ..counted
            }
            .overdraw(),
            None
        );
        assert_eq!(
            Counters {
                fragments: None,
                ..counted
            }
            .overdraw(),
            None
        );
    }
}
