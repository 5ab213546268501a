//! Which stages a frame needs, from what changed since the frame before.

use super::{Camera, Posed, Skip};
use glam::DAffine3;

/// The stages of one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Needed {
    /// `features` and `nodes`: what the networks see has changed.
    pub pose: bool,
    /// Of what the networks see, only the expression, which the head's alone do.
    pub expression_only: bool,
    /// `splats`, `sort` and `raster`: something in the picture has changed.
    pub view: bool,
}

/// Remembers what the last frame showed.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    input: Option<Vec<f64>>,
    view: Option<(Vec<DAffine3>, Camera)>,
}

impl Plan {
    /// What the next frame needs, but for what `skip` lets it leave out.
    pub fn next(&mut self, posed: &Posed, camera: &Camera, skip: Skip) -> Needed {
        let pose = !skip.contains(Skip::POSE) || self.input.as_ref() != Some(&posed.input);
        let body = |input: &[f64]| input[..input.len().saturating_sub(posed.expression)].to_vec();
        let expression_only = skip.contains(Skip::EXPRESSION)
            && self.input.as_ref().is_some_and(|before| before.len() == posed.input.len() && body(before) == body(&posed.input));
        let same = |(joints, before): &(Vec<DAffine3>, Camera)| *joints == posed.joints && before == camera;
        let view = pose || !skip.contains(Skip::FRAME) || !self.view.as_ref().is_some_and(same);
        if pose {
            self.input = Some(posed.input.clone());
        }
        if view {
            self.view = Some((posed.joints.clone(), *camera));
        }
        Needed { pose, expression_only: pose && expression_only, view }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn only_what_changed_is_drawn_again() {
        let camera = |yaw| Camera::orbit(DVec3::ZERO, yaw, 0.0, 2.0, 0.7, [64, 64]);
        let mut posed = Posed { joints: vec![DAffine3::IDENTITY], input: vec![0.0], expression: 0 };
        let mut plan = Plan::default();
        assert_eq!(plan.next(&posed, &camera(0.0), Skip::all()), Needed { pose: true, expression_only: false, view: true });
        assert_eq!(plan.next(&posed, &camera(0.0), Skip::all()), Needed { pose: false, expression_only: false, view: false });
        assert_eq!(plan.next(&posed, &camera(0.1), Skip::all()), Needed { pose: false, expression_only: false, view: true });
        posed.joints[0] = DAffine3::from_translation(DVec3::X);
        assert_eq!(plan.next(&posed, &camera(0.1), Skip::all()), Needed { pose: false, expression_only: false, view: true });
        posed.input[0] = 1.0;
        assert_eq!(plan.next(&posed, &camera(0.1), Skip::all()), Needed { pose: true, expression_only: false, view: true });
        assert_eq!(plan.next(&posed, &camera(0.1), Skip::empty()), Needed { pose: true, expression_only: false, view: true });
        assert_eq!(plan.next(&posed, &camera(0.1), Skip::POSE), Needed { pose: false, expression_only: false, view: true });
        assert_eq!(plan.next(&posed, &camera(0.1), Skip::all()), Needed { pose: false, expression_only: false, view: false });
        // The last number is the expression's.
        posed = Posed { input: vec![1.0, 2.0], expression: 1, ..posed };
        assert!(!plan.next(&posed, &camera(0.1), Skip::all()).expression_only);
        posed.input[1] = 3.0;
        let expression = Needed { pose: true, expression_only: true, view: true };
        assert_eq!(plan.next(&posed, &camera(0.1), Skip::all()), expression);
        posed.input[1] = 4.0;
        assert!(!plan.next(&posed, &camera(0.1), Skip::all() - Skip::EXPRESSION).expression_only);
        posed.input = vec![5.0, 6.0];
        assert!(!plan.next(&posed, &camera(0.1), Skip::all()).expression_only);
    }
}
