//! What a frame took in, left out and drew, in numbers that do not depend on how fast a device is.

use serde::{Deserialize, Serialize};

/// Counts of one frame. Every Gaussian that came in is either drawn or left out. A frame that draws nothing anew leaves all counts 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counters {
    /// Avatars in the scene.
    pub avatars: u64,
    /// Avatars all outside the view, for which nothing was done.
    pub avatars_culled: u64,
    /// Gaussians of all avatars in the scene.
    pub gaussians: u64,
    /// Not looked at, since a coarser level of detail does without: part of those left out.
    pub thinned: u64,
    /// Left out: those of avatars that were left out, those of finer levels of detail, and for the reasons below.
    pub culled: u64,
    /// Why Gaussians of the other avatars were left out. None where nobody counted.
    pub reasons: Option<Reasons>,
    /// Drawn: sorted and rasterized.
    pub drawn: u64,
    /// Networks that ran.
    pub networks: u64,
    /// Parts all outside the view.
    pub parts_outside: u64,
    /// Gaussians that were projected from what an earlier frame kept: all that an avatar's level of detail draws, or none.
    pub kept: u64,
    /// With hulls fragment shader invocations, of drivers that count them only those that blend; with tiles the pixels of all squares of
    /// 4 × 4 that splats were put on. Not to be compared with each other. None where the device has no pipeline statistics.
    pub fragments: Option<u64>,
    /// Pixels that something was drawn into. None where nobody counted them.
    pub covered: Option<u64>,
    /// Pixels of the picture that were drawn, empty ones too: a box around the avatars in view and where they were before, or all.
    pub area: u64,
    /// Compute dispatches.
    pub dispatches: u64,
    /// Command buffers submitted: 0 for a frame that needed nothing.
    pub submitted: u64,
}

/// Gaussians left out one by one, by the first reason that was found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Reasons {
    /// Nearer than the near plane, or nowhere in the picture.
    pub outside: u64,
    /// Behind the depth surface.
    pub hidden: u64,
    /// Never as opaque as the cutoff.
    pub faint: u64,
    /// Of a shape that is no number, or beyond what f32 can tell.
    pub degenerate: u64,
}

impl Counters {
    /// Every count under its name, in the order of the fields; those that nobody counted are left out.
    pub fn named(&self) -> impl Iterator<Item = (&'static str, u64)> {
        let all = [
            ("avatars", Some(self.avatars)),
            ("avatars_culled", Some(self.avatars_culled)),
            ("gaussians", Some(self.gaussians)),
            ("culled", Some(self.culled)),
            ("thinned", Some(self.thinned)),
            ("outside", self.reasons.map(|reasons| reasons.outside)),
            ("hidden", self.reasons.map(|reasons| reasons.hidden)),
            ("faint", self.reasons.map(|reasons| reasons.faint)),
            ("degenerate", self.reasons.map(|reasons| reasons.degenerate)),
            ("drawn", Some(self.drawn)),
            ("networks", Some(self.networks)),
            ("parts_outside", Some(self.parts_outside)),
            ("kept", Some(self.kept)),
            ("fragments", self.fragments),
            ("covered", self.covered),
            ("area", Some(self.area)),
            ("dispatches", Some(self.dispatches)),
            ("submitted", Some(self.submitted)),
        ];
        all.into_iter().filter_map(|(name, count)| Some((name, count?)))
    }

    /// Fragments shaded for each covered pixel. None where either is unknown or nothing is covered.
    pub fn overdraw(&self) -> Option<f64> {
        let (fragments, covered) = (self.fragments?, self.covered?);
        (covered > 0).then(|| fragments as f64 / covered as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overdraw_is_unknown_where_nothing_was_counted_or_covered() {
        let counted = Counters { fragments: Some(30), covered: Some(12), ..Counters::default() };
        assert_eq!(counted.overdraw(), Some(2.5));
        assert_eq!(counted.named().count(), 14);
        assert_eq!(Counters { reasons: Some(Reasons::default()), ..counted }.named().count(), 18);
        assert_eq!(Counters::default().named().count(), 12);
        assert_eq!(Counters { covered: Some(0), ..counted }.overdraw(), None);
        assert_eq!(Counters { fragments: None, ..counted }.overdraw(), None);
    }
}
