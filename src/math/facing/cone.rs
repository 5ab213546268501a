//! The narrowest cone around some directions.

use effigy_core::{avatar::Facing, constants::FACING_FADE};
use glam::Vec3;

/// Steps that the axis takes towards the direction furthest from it.
const STEPS: usize = 40;

/// A cone in which no given direction fades; none without directions. They have length 1.
///
/// Its axis is found as the centre of the smallest enclosing ball (Bădoiu and Clarkson, 2003): it
/// moves to what is furthest from it, less with each step.
pub fn cone(directions: &[Vec3]) -> Option<Facing> {
    let furthest = |axis: Vec3| {
        let all = directions.iter().copied();
        all.min_by(|a, b| a.dot(axis).total_cmp(&b.dot(axis)))
    };
    let mut axis = directions.iter().sum::<Vec3>().normalize_or(Vec3::Z);
    let mut towards = furthest(axis)?;
    let mut best = axis;
    let mut least = towards.dot(axis);
    for step in 0..STEPS {
        let share = 1.0 / (step as f32 + 2.0);
        axis = axis.lerp(towards, share).normalize_or(axis);
        towards = furthest(axis)?;
        if towards.dot(axis) > least {
            best = axis;
            least = towards.dot(axis);
        }
    }
    Some(Facing {
        axis: best.as_dvec3(),
        limit: (f64::from(least) - FACING_FADE).max(Facing::EVERYWHERE.limit),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::random::Random;
    use glam::DVec3;

    #[test]
    fn nothing_that_was_seen_fades_and_the_cone_is_narrow() {
        let random = &mut Random::new(7, 0);
        let vector = |random: &mut Random| {
            DVec3::new(random.normal(), random.normal(), random.normal()).normalize()
        };
        for _ in 0..100 {
            let axis = vector(random);
            let least = random.range(-0.2, 0.9);
            let inside: Vec<Vec3> = std::iter::repeat_with(|| vector(random))
                .filter(|own| own.dot(axis) > least)
                .take(300)
                .map(|own| own.as_vec3())
                .collect();
            let cone = cone(&inside).expect("there are directions");
            assert!(
                inside
                    .iter()
                    .all(|own| cone.fade(own.as_dvec3()) >= 1.0 - 1e-6)
            );
            let narrowest = least - FACING_FADE;
            assert!(cone.limit > narrowest - 0.1, "{} {narrowest}", cone.limit);
        }
        assert_eq!(cone(&[]), None);
        let sides = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| [axis, -axis]);
        let cone = cone(sides.as_flattened()).expect("there are directions");
        for side in sides.as_flattened() {
            assert!(cone.fade(side.as_dvec3()) >= 1.0 - 1e-6, "{side}");
        }
    }
}
