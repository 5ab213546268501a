//! Which stages a frame needs, from what changed since the frame before.

use super::{Camera, Needs, PartSet, Posed, Skip};
use glam::DAffine3;

/// Where `splats` has what no camera changes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// From the model.
    Compute,
    /// From the model, and it is kept.
    Keep,
    /// From what an earlier frame kept.
    Kept,
}

/// The stages of one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Needed {
    /// `features` and `nodes`: what the networks see has changed.
    pub pose: bool,
    /// Of what the networks see, only the expression, which the head's alone do.
    pub expression_only: bool,
    /// `splats`, `sort` and `raster`: something in the picture has changed.
    pub view: bool,
    pub body: Body,
}

/// Remembers what the last frame showed.
#[derive(Clone, Debug)]
pub struct Plan {
    input: Option<Vec<f64>>,
    /// Joints, camera, and level of detail.
    view: Option<(Vec<DAffine3>, Camera, u32)>,
    /// Whether a frame has kept what the last one showed.
    kept: bool,
    /// Parts whose networks have not run since what they see changed.
    stale: PartSet,
}

impl Default for Plan {
    fn default() -> Self {
        Self { input: None, view: None, kept: false, stale: PartSet::ALL }
    }
}

impl Plan {
    /// The level of detail that the last frame showed.
    pub fn level(&self) -> u32 {
        self.view.as_ref().map_or(0, |(_, _, level)| *level)
    }

    /// What the next frame needs, but for what `skip` lets it leave out. `level`: of detail ([`super::detail`]).
    pub fn next(&mut self, posed: &Posed, camera: &Camera, skip: Skip, level: u32) -> Needed {
        let changed = self.input.as_ref() != Some(&posed.input);
        let pose = !skip.contains(Skip::POSE) || changed;
        let body = |input: &[f64]| input[..input.len().saturating_sub(posed.expression)].to_vec();
        let expression_only = skip.contains(Skip::EXPRESSION)
            && self.input.as_ref().is_some_and(|before| before.len() == posed.input.len() && body(before) == body(&posed.input));
        let still = !changed && self.view.as_ref().is_some_and(|(joints, _, before)| *joints == posed.joints && *before == level);
        let view = pose || !skip.contains(Skip::FRAME) || !(still && self.view.as_ref().is_some_and(|(_, before, _)| before == camera));
        let body = match (still && skip.contains(Skip::SKINNING), self.kept) {
            (false, _) => Body::Compute,
            (true, false) => Body::Keep,
            (true, true) => Body::Kept,
        };
        if pose {
            self.input = Some(posed.input.clone());
        }
        if view {
            self.view = Some((posed.joints.clone(), *camera, level));
            self.kept = body != Body::Compute;
        }
        Needed { pose, expression_only: pose && expression_only, view, body }
    }

    /// A frame that something else needed has shown this too, as [`Self::next`] said.
    pub fn shown(&mut self, needed: &Needed) {
        self.kept = needed.body != Body::Compute;
    }

    /// The networks that run in a frame that shows `seen`, of those that what has changed since they ran concerns. The others wait until
    /// they are seen; a frame that keeps the body needs all that move something. None: all run that something has changed for.
    pub fn networks(&mut self, needed: &Needed, needs: &Needs, seen: Option<&PartSet>) -> PartSet {
        match (needed.pose, needed.expression_only) {
            (true, true) => self.stale = self.stale | needs.head,
            (true, false) => self.stale = needs.all(),
            (false, _) => {}
        }
        let drawn = match seen {
            None => needs.all(),
            Some(seen) if needed.body == Body::Compute => needs.networks(seen),
            Some(_) => needs.networks(&PartSet::ALL),
        };
        let run = self.stale & drawn;
        self.stale = self.stale - run;
        run
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn only_what_changed_is_drawn_again() {
        let (compute, keep, kept) = (Body::Compute, Body::Keep, Body::Kept);
        let camera = |yaw| Camera::orbit(DVec3::ZERO, yaw, 0.0, 2.0, 0.7, [64, 64]);
        let mut posed = Posed { joints: vec![DAffine3::IDENTITY], input: vec![0.0], expression: 0 };
        let mut plan = Plan::default();
        assert_eq!(
            plan.next(&posed, &camera(0.0), Skip::all(), 0),
            Needed { pose: true, expression_only: false, view: true, body: compute }
        );
        assert_eq!(
            plan.next(&posed, &camera(0.0), Skip::all(), 0),
            Needed { pose: false, expression_only: false, view: false, body: keep }
        );
        assert_eq!(plan.next(&posed, &camera(0.1), Skip::all(), 0), Needed { pose: false, expression_only: false, view: true, body: keep });
        assert_eq!(plan.next(&posed, &camera(0.2), Skip::all(), 0), Needed { pose: false, expression_only: false, view: true, body: kept });
        // Of another level of detail, other Gaussians were kept.
        let level = |plan: &mut Plan, level| plan.next(&posed, &camera(0.2), Skip::all(), level);
        assert_eq!(level(&mut plan, 1), Needed { pose: false, expression_only: false, view: true, body: compute });
        assert_eq!(level(&mut plan, 1), Needed { pose: false, expression_only: false, view: false, body: keep });
        posed.joints[0] = DAffine3::from_translation(DVec3::X);
        assert_eq!(
            plan.next(&posed, &camera(0.1), Skip::all(), 0),
            Needed { pose: false, expression_only: false, view: true, body: compute }
        );
        posed.input[0] = 1.0;
        assert_eq!(
            plan.next(&posed, &camera(0.1), Skip::all(), 0),
            Needed { pose: true, expression_only: false, view: true, body: compute }
        );
        assert_eq!(
            plan.next(&posed, &camera(0.1), Skip::empty(), 0),
            Needed { pose: true, expression_only: false, view: true, body: compute }
        );
        assert_eq!(
            plan.next(&posed, &camera(0.1), Skip::POSE, 0),
            Needed { pose: false, expression_only: false, view: true, body: compute }
        );
        assert_eq!(
            plan.next(&posed, &camera(0.1), Skip::all(), 0),
            Needed { pose: false, expression_only: false, view: false, body: keep }
        );
        // The last number is the expression's.
        posed = Posed { input: vec![1.0, 2.0], expression: 1, ..posed };
        assert!(!plan.next(&posed, &camera(0.1), Skip::all(), 0).expression_only);
        posed.input[1] = 3.0;
        let expression = Needed { pose: true, expression_only: true, view: true, body: compute };
        assert_eq!(plan.next(&posed, &camera(0.1), Skip::all(), 0), expression);
        posed.input[1] = 4.0;
        assert!(!plan.next(&posed, &camera(0.1), Skip::all() - Skip::EXPRESSION, 0).expression_only);
        posed.input = vec![5.0, 6.0];
        assert!(!plan.next(&posed, &camera(0.1), Skip::all(), 0).expression_only);
    }
    #[test]
    fn networks_wait_until_they_are_seen() {
        let avatar = crate::demo::avatar().unwrap();
        let needs = Needs::new(&avatar);
        let (all, one) = (needs.all(), PartSet::first(1));
        let mut plan = Plan::default();
        let needed = |pose, expression_only, body| Needed { pose, expression_only, view: true, body };
        assert_eq!(plan.networks(&needed(true, false, Body::Compute), &needs, Some(&one)), needs.networks(&one));
        assert!(plan.networks(&needed(false, false, Body::Compute), &needs, Some(&one)).is_empty());
        assert_eq!(plan.networks(&needed(false, false, Body::Compute), &needs, Some(&all)), all - needs.networks(&one));
        assert!(plan.networks(&needed(false, false, Body::Keep), &needs, Some(&one)).is_empty());
        assert_eq!(plan.networks(&needed(true, true, Body::Compute), &needs, Some(&all)), needs.head);
        // The expression changes while some of the body waits.
        plan.networks(&needed(true, false, Body::Compute), &needs, Some(&one));
        assert_eq!(plan.networks(&needed(true, true, Body::Compute), &needs, Some(&all)), needs.head | (all - needs.networks(&one)));
        plan.networks(&needed(true, false, Body::Compute), &needs, Some(&one));
        assert_eq!(plan.networks(&needed(false, false, Body::Keep), &needs, Some(&one)), all - needs.networks(&one));
        assert_eq!(plan.networks(&needed(true, false, Body::Compute), &needs, None), all);
    }
}
