//! Which stages a frame needs, from what changed since the frame before.

use super::{Camera, Posed};
use glam::DAffine3;

/// The stages of one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Needed {
    /// `features` and `nodes`: what the networks see has changed.
    pub pose: bool,
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
    /// What the next frame needs; everything where `skip` is off.
    pub fn next(&mut self, posed: &Posed, camera: &Camera, skip: bool) -> Needed {
        let pose = !skip || self.input.as_ref() != Some(&posed.input);
        let same = |(joints, before): &(Vec<DAffine3>, Camera)| *joints == posed.joints && before == camera;
        let view = pose || !self.view.as_ref().is_some_and(same);
        if pose {
            self.input = Some(posed.input.clone());
        }
        if view {
            self.view = Some((posed.joints.clone(), *camera));
        }
        Needed { pose, view }
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
        assert_eq!(plan.next(&posed, &camera(0.0), true), Needed { pose: true, view: true });
        assert_eq!(plan.next(&posed, &camera(0.0), true), Needed { pose: false, view: false });
        assert_eq!(plan.next(&posed, &camera(0.1), true), Needed { pose: false, view: true });
        posed.joints[0] = DAffine3::from_translation(DVec3::X);
        assert_eq!(plan.next(&posed, &camera(0.1), true), Needed { pose: false, view: true });
        posed.input[0] = 1.0;
        assert_eq!(plan.next(&posed, &camera(0.1), true), Needed { pose: true, view: true });
        assert_eq!(plan.next(&posed, &camera(0.1), false), Needed { pose: true, view: true });
    }
}
