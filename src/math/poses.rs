//! Poses of an avatar: of clips, or random ones of those that it was trained for.

use effigy_core::avatar::{Avatar, Pose, Subspace, motion::Player};
use effigy_core::random::Random;
use glam::DVec3;

/// Standard deviation of a joint's rotation about each axis where nothing tells how joints move,
/// radians.
const JOINT_SIGMA: f64 = 0.2;
/// Furthest that a random pose is from the mean along a component, in standard deviations.
const FURTHEST: f64 = 2.0;

/// Poses from clips, `count` of them, evenly spaced over the clips' frames. `phase`: where between
/// two neighbouring ones they begin, 0 to 1; sets with different phases share no pose.
pub fn from_clips(players: &[Player], count: usize, phase: f64) -> Vec<Pose> {
    let all: f64 = players.iter().map(|player| player.clip().duration()).sum();
    let pose = |k: usize| {
        let mut at = (k as f64 + phase) / count as f64 * all;
        for player in players {
            let duration = player.clip().duration();
            if at <= duration {
                return Some(player.pose(at));
            }
            at -= duration;
        }
        players.last().map(|player| player.pose(f64::MAX))
    };
    (0..count).filter_map(pose).collect()
}

/// Random poses of an avatar: of the space of its training poses where it has one, else with every
/// joint but the root turned a little. Only the rest pose for an avatar that has one joint.
pub fn random(avatar: &Avatar, count: usize, seed: u64) -> Vec<Pose> {
    let joints = avatar.skeleton.len();
    if joints == 1 && avatar.inputs.is_empty() {
        return vec![Pose::rest(joints, 0)];
    }
    let pose = |k: usize| {
        let random = &mut Random::new(seed, k as u64);
        let mut pose = Pose::rest(joints, avatar.inputs.expression);
        match &avatar.inputs.pose_space {
            Some(space) => {
                let theta = point(space, random);
                let (vectors, _) = theta.as_chunks::<3>();
                for (&joint, &vector) in avatar.inputs.joint.iter().zip(vectors) {
                    pose.rotation[usize::from(joint)] = DVec3::from(vector);
                }
            }
            None => {
                turn(&mut pose, JOINT_SIGMA, random);
            }
        }
        if let Some(space) = &avatar.inputs.expression_space {
            pose.expression = point(space, random);
        }
        pose
    };
    (0..count).map(pose).collect()
}

/// Turns every joint but the root further, by a rotation vector of this standard deviation along
/// each axis, radians.
pub fn turn(pose: &mut Pose, deviation: f64, random: &mut Random) {
    for rotation in pose.rotation.iter_mut().skip(1) {
        *rotation += deviation * DVec3::new(random.normal(), random.normal(), random.normal());
    }
}

/// A random point of a subspace.
fn point(space: &Subspace, random: &mut Random) -> Vec<f64> {
    let mut point: Vec<f64> = space.mean.iter().map(|&m| f64::from(m)).collect();
    let components = space.component.chunks_exact(space.mean.len().max(1));
    for (component, &sigma) in components.zip(&space.sigma) {
        let along = random.normal().clamp(-FURTHEST, FURTHEST) * f64::from(sigma);
        for (x, &c) in point.iter_mut().zip(component) {
            *x += along * f64::from(c);
        }
    }
    point
}
