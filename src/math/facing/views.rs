//! Views in which an avatar should look whole: all of it from all sides, and parts of it from near.

use crate::poses;
use crate::sampling::evenly_spaced;
use effigy_core::avatar::{Avatar, Pose};
use effigy_core::random::Random;
use effigy_core::reference::project::skinning;
use effigy_core::scene::{AvatarBounds, Camera, Posed};
use std::f64::consts::TAU;

/// Poses that are seen.
const POSES: usize = 64;
/// At most so many of them are given ones.
pub const GIVEN_POSES: usize = POSES / 2;
/// Largest standard deviation by which joints are turned further in three of four poses, radians:
/// what clothes and limbs hide shows in poses that no clip has.
const TURNED: f64 = 0.8;
/// Views of a pose from a distance at which all of it is in the image, or further.
const AROUND: usize = 8;
/// Views of a random Gaussian from near.
const NEAR: usize = 4;
/// Vertical field of view of near views, radians.
const FOV: f64 = 35f64.to_radians();
/// Sides of an image, px.
const SIDE: u32 = 640;
/// Distances of near views, in those at which all of an avatar is in the image.
const NEAR_DISTANCES: [f64; 2] = [0.12, 0.5];
/// The furthest of the others.
const FURTHEST: f64 = 2.0;
/// Radians that cameras look down or up at most.
const PITCH: f64 = 1.2;
/// Decides poses and cameras.
const SEED: u64 = 5;

/// A pose and a camera.
pub struct FacingView {
    pub posed: Posed,
    pub camera: Camera,
}

/// Views of an avatar in some of the given poses and in random ones.
pub fn views(avatar: &Avatar, given: &[Pose]) -> Vec<FacingView> {
    let mut poses = evenly_spaced(given, GIVEN_POSES);
    poses.extend(poses::random(avatar, POSES - poses.len(), SEED));
    let bounds = AvatarBounds::new(avatar);
    let gaussians = &avatar.gaussians;
    let of_pose = |index: usize| {
        let mut random = Random::new(SEED, index as u64);
        let mut pose = poses[index % poses.len()].clone();
        if !index.is_multiple_of(4) {
            let deviation = random.range(0.0, TURNED);
            poses::turn(&mut pose, deviation, &mut random);
        }
        let posed = Posed::new(avatar, &pose);
        let framing = bounds.framing(&posed.joints);
        let size = [SIDE; 2];
        let whole = Camera::framing_distance(framing.bounds, FOV, size);
        let camera = |view: usize| {
            let is_near = view >= AROUND;
            let yaw =
                TAU * (view as f64 + random.uniform()) / if is_near { NEAR } else { AROUND } as f64;
            let pitch = random.range(-PITCH, PITCH);
            let [least, most] = if is_near {
                NEAR_DISTANCES
            } else {
                [1.0, FURTHEST]
            };
            let distance = whole * least * (most / least).powf(random.uniform());
            let target = if is_near {
                let of = (random.uniform() * gaussians.len() as f64) as usize;
                let g = skinning(
                    &posed.joints,
                    gaussians.joint[of],
                    gaussians.joint_weight[of],
                );
                g.transform_point3(avatar.position(of))
            } else {
                framing.middle()
            };
            // What is further away fills the image too.
            let fov = if is_near { FOV } else { FOV * whole / distance };
            Camera {
                near: framing.near,
                ..Camera::orbit(target, yaw, pitch, distance, fov, size)
            }
        };
        (0..AROUND + NEAR)
            .map(camera)
            .map(|camera| FacingView {
                posed: posed.clone(),
                camera,
            })
            .collect::<Vec<_>>()
    };
    (0..POSES).flat_map(of_pose).collect()
}
