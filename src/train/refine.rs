//! Poses, cameras and bones that are learned with the avatar: a capture's are off by a little.

use crate::adam::{Adam, Moments};
use effigy_capture::Capture;
use effigy_core::avatar::{Clip, Pose, PoseGradient, Skeleton};
use effigy_core::scene::Camera;
use glam::{DAffine3, DQuat, DVec3};

/// Numbers of a camera: how far it is turned and moved.
const CAMERA: usize = 6;
/// [`Moments::direction`]'s floor for poses: fingers of a few pixels drifted by 1.5° without one.
const POSE_FLOOR: f64 = 0.2;
/// Frames a second of clips of poses.
const CLIP_RATE: f64 = 30.0;

/// A list of items that learn, each of so many numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Items {
    /// Item after item.
    pub values: Vec<f64>,
    /// How they learn.
    pub moments: Moments,
}

/// The poses of a capture's frames, the positions of its cameras and the lengths of its person's
/// bones, refined so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Refinement {
    /// Of each frame: a vector a joint, its axis-angle rotation, radians; the translation, metres.
    pub poses: Items,
    /// Of each camera, in its own coordinates and after its view matrix: an axis-angle rotation,
    /// radians, and a translation, metres.
    pub cameras: Items,
    /// Of each joint: how far it is from where the body model has it in its parent, metres.
    pub bones: Items,
}

/// How far poses, cameras and bones go in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RefineRates {
    /// Of poses, radians and metres.
    pub pose: f64,
    /// Of cameras, radians and metres.
    pub camera: f64,
    /// Of bones, metres.
    pub bone: f64,
}

/// A pose that a camera saw.
#[derive(Clone, Copy)]
pub struct SeenFrom<'a> {
    /// Whose pose.
    pub skeleton: &'a Skeleton,
    /// The pose.
    pub pose: &'a Pose,
    /// The derivative of the view's loss with respect to it.
    pub gradient: &'a PoseGradient,
}

impl RefineRates {
    /// Whether anything of it learns.
    pub fn any(&self) -> bool {
        self.pose > 0.0 || self.camera > 0.0 || self.bone > 0.0
    }
}

impl Items {
    fn new(items: usize, width: usize) -> Self {
        Self {
            values: vec![0.0; items * width],
            moments: Moments::new(items, width),
        }
    }

    /// From arrays of a checkpoint; None where their lengths don't fit each other.
    pub fn from_arrays(
        values: Vec<f64>,
        first: Vec<f64>,
        second: Vec<f64>,
        updates: Vec<u64>,
    ) -> Option<Self> {
        Some(Self {
            moments: Moments::from_arrays(first, second, updates)?,
            values,
        })
        .filter(|items| items.values.len() == items.moments.first.len())
    }

    fn item(&self, item: usize) -> &[f64] {
        let width = self.moments.width();
        &self.values[item * width..][..width]
    }

    fn item_mut(&mut self, item: usize) -> &mut [f64] {
        let width = self.moments.width();
        &mut self.values[item * width..][..width]
    }
}

/// The derivative of a loss with respect to a camera's motion after its view matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CameraGradient {
    /// Of a turn, radians.
    pub turn: DVec3,
    /// Of a shift, metres.
    pub shift: DVec3,
}

impl CameraGradient {
    /// Adds that of another view.
    pub fn add(&mut self, other: &Self) {
        self.turn += other.turn;
        self.shift += other.shift;
    }

    /// Of a camera with a view matrix: one that moves is all of the person that moves the other way.
    fn new(view: &DAffine3, seen: SeenFrom) -> Self {
        let rest = seen.skeleton.rest.first().copied().unwrap_or_default();
        let root = DVec3::from(rest.map(f64::from)) + seen.pose.translation;
        let about_root = seen.gradient.rotation.first().copied().unwrap_or_default();
        let force = seen.gradient.translation;
        let eye = view.inverse().translation;
        Self {
            turn: view.matrix3 * (about_root + (root - eye).cross(force)),
            shift: view.matrix3 * force,
        }
    }
}

/// A turn after another, both axis-angle.
fn turned(by: DVec3, rotation: DVec3) -> DVec3 {
    (DQuat::from_scaled_axis(by) * DQuat::from_scaled_axis(rotation)).to_scaled_axis()
}

impl Refinement {
    /// Poses and cameras as a capture has them.
    pub fn new(capture: &Capture) -> Self {
        let joints = capture.template.skeleton.len();
        let poses: Vec<&Pose> = capture.frames.iter().map(|frame| &frame.pose).collect();
        Self::of(joints, &poses, capture.cameras.len())
    }

    /// Of poses of so many joints, and so many cameras.
    pub fn of(joints: usize, given: &[&Pose], cameras: usize) -> Self {
        let mut poses = Items::new(given.len(), 3 * joints + 3);
        for (at, pose) in given.iter().enumerate() {
            let own = poses.item_mut(at);
            for (to, rotation) in own.chunks_exact_mut(3).zip(&pose.rotation) {
                to.copy_from_slice(&rotation.to_array());
            }
            own[3 * joints..].copy_from_slice(&pose.translation.to_array());
        }
        Self {
            poses,
            cameras: Items::new(cameras, CAMERA),
            bones: Items::new(joints, 3),
        }
    }

    /// Everything that learns.
    pub fn items(&self) -> [&Items; 3] {
        [&self.poses, &self.cameras, &self.bones]
    }

    /// All numbers that a step changes.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        self.items()
            .into_iter()
            .flat_map(|items| items.values.iter().copied().chain(items.moments.numbers()))
    }

    /// Whether it has as many frames, joints and cameras as another.
    pub fn fits(&self, other: &Self) -> bool {
        let shape = |own: &Self| {
            own.items()
                .map(|items| [items.values.len(), items.moments.items()])
        };
        shape(self) == shape(other)
    }

    /// The skeleton with refined bones. `given`: the body model's.
    pub fn skeleton(&self, given: &Skeleton) -> Skeleton {
        let bones = self.bones.values.chunks_exact(3).map(DVec3::from_slice);
        given.with_bones(&bones.collect::<Vec<_>>())
    }

    /// A step of Adam for all bones, along the derivative of a loss with respect to the poses of its
    /// views, summed.
    pub fn learn_bones(&mut self, gradient: &PoseGradient, rate: f64, adam: &Adam) {
        // The root's place is the poses' translation. No floor, unlike poses: all frames' views speak
        // of a bone, so that what is left of noise in a finger's is small.
        for (joint, of) in gradient.bone.iter().enumerate().skip(1) {
            let of = of.to_array();
            let change = self.bones.moments.direction(joint, &of, 0.0, adam);
            for (own, change) in self.bones.item_mut(joint).iter_mut().zip(change) {
                *own -= rate * change;
            }
        }
    }

    /// The pose of a frame. `given`: the capture's, whose expression stays as it is.
    pub fn pose(&self, frame: usize, given: &Pose) -> Pose {
        let own = self.poses.item(frame);
        let vectors = own.chunks_exact(3).map(DVec3::from_slice);
        let mut rotation: Vec<DVec3> = vectors.collect();
        Pose {
            translation: rotation.pop().unwrap_or_default(),
            rotation,
            expression: given.expression.clone(),
        }
    }

    /// A camera, or a part of its image. `given`: as the capture has it.
    pub fn camera(&self, camera: usize, given: &Camera) -> Camera {
        let own = self.cameras.item(camera);
        let motion = DAffine3::from_rotation_translation(
            DQuat::from_scaled_axis(DVec3::from_slice(own)),
            DVec3::from_slice(&own[3..]),
        );
        Camera {
            view: motion * given.view,
            ..*given
        }
    }

    /// A step of Adam for the pose of a frame, along the derivative of a loss with respect to it.
    pub fn learn_pose(&mut self, frame: usize, gradient: &PoseGradient, rate: f64, adam: &Adam) {
        let mut of: Vec<f64> = gradient.rotation.iter().flat_map(DVec3::to_array).collect();
        of.extend(gradient.translation.to_array());
        let change = self.poses.moments.direction(frame, &of, POSE_FLOOR, adam);
        let own = self.poses.item_mut(frame);
        let joints = own.len() / 3 - 1;
        for (at, (own, change)) in own
            .chunks_exact_mut(3)
            .zip(change.chunks_exact(3))
            .enumerate()
        {
            let by = -rate * DVec3::from_slice(change);
            let old = DVec3::from_slice(own);
            let new = if at < joints {
                turned(by, old)
            } else {
                old + by
            };
            own.copy_from_slice(&new.to_array());
        }
    }

    /// The derivative of a view's loss with respect to its camera's motion. `given`: the camera as
    /// the capture has it; `seen`: in that view.
    pub fn camera_gradient(&self, camera: usize, given: &Camera, seen: SeenFrom) -> CameraGradient {
        CameraGradient::new(&self.camera(camera, given).view, seen)
    }

    /// A step of Adam for a camera.
    pub fn learn_camera(
        &mut self,
        camera: usize,
        gradient: &CameraGradient,
        rate: f64,
        adam: &Adam,
    ) {
        let of = [gradient.turn.to_array(), gradient.shift.to_array()].concat();
        let change = self.cameras.moments.direction(camera, &of, 0.0, adam);
        let own = self.cameras.item_mut(camera);
        let by = -rate * DVec3::from_slice(&change);
        let turn = turned(by, DVec3::from_slice(own));
        let shift = DQuat::from_scaled_axis(by) * DVec3::from_slice(&own[3..])
            - rate * DVec3::from_slice(&change[3..]);
        own[..3].copy_from_slice(&turn.to_array());
        own[3..].copy_from_slice(&shift.to_array());
    }

    /// Takes out the motion that all cameras that learned share, which is one of the world. `given`:
    /// the capture's cameras.
    pub fn center(&mut self, given: &[&Camera]) {
        let learned: Vec<usize> = (0..given.len())
            .filter(|&camera| self.cameras.moments.updates(camera) > 0)
            .collect();
        let mut mean = [DVec3::ZERO; 2];
        for &camera in &learned {
            let own = self.cameras.item(camera);
            let Camera { view, .. } = given[camera];
            let back = view.matrix3.transpose();
            let turn = back * DVec3::from_slice(own);
            let eye = view.inverse().translation;
            mean[0] += turn / learned.len() as f64;
            mean[1] +=
                (back * DVec3::from_slice(&own[3..]) - turn.cross(eye)) / learned.len() as f64;
        }
        for &camera in &learned {
            let Camera { view, .. } = given[camera];
            let eye = view.inverse().translation;
            let own = self.cameras.item_mut(camera);
            let turn = DVec3::from_slice(own) - view.matrix3 * mean[0];
            let shift =
                DVec3::from_slice(&own[3..]) - view.matrix3 * (mean[1] + mean[0].cross(eye));
            own[..3].copy_from_slice(&turn.to_array());
            own[3..].copy_from_slice(&shift.to_array());
        }
    }

    /// The poses of all frames, as a clip. A capture has no rate: it gets 30 frames a second.
    pub fn clip(&self, capture: &Capture, name: &str) -> Clip {
        let frames = capture.frames.iter().enumerate();
        let poses: Vec<Pose> = frames
            .map(|(at, frame)| self.pose(at, &frame.pose))
            .collect();
        let longest = poses.iter().map(|pose| pose.expression.len()).max();
        let expression_len = longest.unwrap_or(0);
        let floats = |v: &DVec3| v.as_vec3().to_array();
        let expression = |pose: &Pose| {
            let mut own: Vec<f32> = pose.expression.iter().map(|&v| v as f32).collect();
            own.resize(expression_len, 0.0);
            own
        };
        Clip {
            name: name.into(),
            credit: String::new(),
            rate: CLIP_RATE,
            joint: capture.template.skeleton.name.clone(),
            rotation: poses
                .iter()
                .flat_map(|pose| pose.rotation.iter().map(floats))
                .collect(),
            translation: poses.iter().map(|pose| floats(&pose.translation)).collect(),
            expression: poses.iter().flat_map(expression).collect(),
            expression_len,
        }
    }

    /// How far joints are from where the body model has them in their parents, metres: the mean and
    /// the most. None where no bone learned.
    pub fn bones_moved(&self) -> Option<[f64; 2]> {
        let learned =
            (0..self.bones.moments.items()).filter(|&j| self.bones.moments.updates(j) > 0);
        let moved: Vec<f64> = learned
            .map(|joint| DVec3::from_slice(self.bones.item(joint)).length())
            .collect();
        let mean = moved.iter().sum::<f64>() / moved.len() as f64;
        let most = moved.iter().copied().reduce(f64::max)?;
        Some([mean, most])
    }

    /// How far joints that were looked at are turned from what the capture says, radians: the mean
    /// and the most. None where no pose learned.
    pub fn turned_from(&self, capture: &Capture) -> Option<[f64; 2]> {
        let mut sum = 0.0;
        let mut most: f64 = 0.0;
        let mut count = 0;
        for (at, frame) in capture.frames.iter().enumerate() {
            if self.poses.moments.updates(at) == 0 {
                continue;
            }
            let own = self.pose(at, &frame.pose);
            for (new, old) in own.rotation.iter().zip(&frame.pose.rotation) {
                let angle = turned(*new, -*old).length();
                sum += angle;
                most = most.max(angle);
                count += 1;
            }
        }
        (count > 0).then(|| [sum / f64::from(count), most])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn skeleton() -> Skeleton {
        Skeleton {
            name: vec!["hips".into(), "arm".into(), "hand".into()],
            parent: vec![None, Some(0), Some(1)],
            rest: vec![[0.0, 0.9, 0.0], [0.2, 1.4, 0.0], [0.7, 1.4, 0.1]],
            canonical: vec![[0.0; 3]; 3],
        }
    }

    fn pose(seed: f64) -> Pose {
        let number = |k: f64| 0.4 * (seed + 1.3 * k).sin();
        Pose {
            rotation: (0..3)
                .map(|j| 3.0 * f64::from(j))
                .map(|j| DVec3::new(number(j), number(j + 1.0), number(j + 2.0)))
                .collect(),
            translation: DVec3::new(number(20.0), number(21.0), number(22.0)),
            expression: vec![],
        }
    }

    /// A point that hangs on each joint.
    const POINTS: [DVec3; 3] = [
        DVec3::new(0.1, 1.2, 0.2),
        DVec3::new(0.5, 1.5, 0.1),
        DVec3::new(0.9, 1.3, -0.2),
    ];

    fn camera(yaw: f64) -> Camera {
        Camera::orbit(DVec3::Y, yaw, 0.1, 3.0, 0.6, [64, 64])
    }

    fn seen(pose: &Pose, view: &DAffine3) -> [DVec3; 3] {
        let joints = skeleton().matrices(pose);
        std::array::from_fn(|j| view.transform_point3(joints[j].transform_point3(POINTS[j])))
    }

    /// Half the squared distance to what a true pose and camera show, and its derivative with
    /// respect to the joints.
    fn loss(pose: &Pose, view: &DAffine3, truth: [DVec3; 3]) -> (f64, Vec<DAffine3>) {
        let found = seen(pose, view);
        let mut sum = 0.0;
        let joints = (0..3)
            .map(|j| {
                let off = found[j] - truth[j];
                sum += 0.5 * off.length_squared();
                let of = view.matrix3.transpose() * off;
                let columns = POINTS[j].to_array().map(|x| of * x);
                DAffine3::from_cols(columns[0], columns[1], columns[2], of)
            })
            .collect();
        (sum, joints)
    }

    fn refinement(frames: usize, cameras: usize) -> Refinement {
        Refinement {
            poses: Items::new(frames, 12),
            cameras: Items::new(cameras, CAMERA),
            bones: Items::new(3, 3),
        }
    }

    #[test]
    fn a_camera_has_the_slope_of_differences() {
        let (pose, view) = (pose(1.0), camera(0.7).view);
        let truth = [DVec3::new(0.3, 0.1, 2.0); 3];
        let (_, joints) = loss(&pose, &view, truth);
        let skeleton = skeleton();
        let gradient = skeleton.matrices_backward(&pose, &joints);
        let found = CameraGradient::new(
            &view,
            SeenFrom {
                skeleton: &skeleton,
                pose: &pose,
                gradient: &gradient,
            },
        );
        let slope = |motion: &dyn Fn(f64) -> DAffine3| {
            let at = |h: f64| loss(&pose, &(motion(h) * view), truth).0;
            (at(1e-5) - at(-1e-5)) / 2e-5
        };
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            let turn = slope(&|h| DAffine3::from_quat(DQuat::from_scaled_axis(h * axis)));
            assert!((found.turn.dot(axis) - turn).abs() < 1e-7);
            let shift = slope(&|h| DAffine3::from_translation(h * axis));
            assert!((found.shift.dot(axis) - shift).abs() < 1e-7);
        }
    }

    #[test]
    fn a_pose_that_is_off_finds_back() {
        let truth = pose(1.0);
        let mut own = refinement(2, 0);
        let off = |own: &Refinement| {
            let view = camera(0.0).view;
            loss(&own.pose(1, &truth), &view, seen(&truth, &view)).0
        };
        let first = off(&own);
        for step in 0..4000 {
            let view = camera(f64::from(step)).view;
            let now = own.pose(1, &truth);
            let (_, joints) = loss(&now, &view, seen(&truth, &view));
            let gradient = skeleton().matrices_backward(&now, &joints);
            let rate = 5e-3 * 0.1f64.powf(f64::from(step) / 2000.0);
            own.learn_pose(1, &gradient, rate, &Adam::DEFAULT);
        }
        let last = off(&own);
        assert!(last < 1e-3 * first, "{first} to {last}");
        // Nobody looked at the other frame.
        assert_eq!(own.pose(0, &truth).rotation, [DVec3::ZERO; 3]);
    }

    #[test]
    fn bones_that_are_off_find_back() {
        let off = [
            DVec3::ZERO,
            DVec3::new(0.03, -0.01, 0.02),
            DVec3::new(-0.04, 0.0, 0.01),
        ];
        let truth = skeleton().with_bones(&off);
        let mut own = refinement(0, 0);
        for step in 0..3000 {
            let pose = pose(0.37 * f64::from(step));
            let view = camera(f64::from(step)).view;
            let now = own.skeleton(&skeleton());
            let shown = |skeleton: &Skeleton| {
                let joints = skeleton.matrices(&pose);
                [0, 1, 2]
                    .map(|j: usize| view.transform_point3(joints[j].transform_point3(POINTS[j])))
            };
            let (expected, found) = (shown(&truth), shown(&now));
            let joints: Vec<DAffine3> = (0..3)
                .map(|j| {
                    let of = view.matrix3.transpose() * (found[j] - expected[j]);
                    let columns = POINTS[j].to_array().map(|x| of * x);
                    DAffine3::from_cols(columns[0], columns[1], columns[2], of)
                })
                .collect();
            let gradient = now.matrices_backward(&pose, &joints);
            let rate = 2e-3 * 0.01f64.powf(f64::from(step) / 3000.0);
            own.learn_bones(&gradient, rate, &Adam::DEFAULT);
        }
        for (joint, off) in off.iter().enumerate() {
            let found = DVec3::from_slice(own.bones.item(joint));
            assert!(found.distance(*off) < 1e-3, "{joint}: {found}, {off}");
        }
    }

    #[test]
    fn cameras_find_back_but_for_a_motion_of_the_world() {
        let all: Vec<Camera> = (0..4).map(|k| camera(1.6 * f64::from(k))).collect();
        let given: Vec<&Camera> = all.iter().collect();
        let off: Vec<DAffine3> = (0..4)
            .map(|k| {
                let angle = 0.02 * DVec3::new(f64::from(k).sin(), 1.0, f64::from(2 * k).cos());
                let shift = 0.03 * DVec3::new(1.0, f64::from(k).cos(), f64::from(3 * k).sin());
                DAffine3::from_rotation_translation(DQuat::from_scaled_axis(angle), shift)
            })
            .collect();
        let mut own = refinement(0, 4);
        for step in 0..6000 {
            let k = step % 4;
            let pose = pose(0.1 * step as f64);
            let view = own.camera(k, given[k]).view;
            let (_, joints) = loss(&pose, &view, seen(&pose, &(off[k] * given[k].view)));
            let skeleton = skeleton();
            let gradient = skeleton.matrices_backward(&pose, &joints);
            let seen = SeenFrom {
                skeleton: &skeleton,
                pose: &pose,
                gradient: &gradient,
            };
            let rate = 2e-3 * 0.01f64.powf(step as f64 / 6000.0);
            let gradient = own.camera_gradient(k, given[k], seen);
            own.learn_camera(k, &gradient, rate, &Adam::DEFAULT);
        }
        let far = |own: &Refinement, world: &DAffine3| -> f64 {
            let points = |k: usize| {
                let a = seen(&pose(3.0), &(own.camera(k, given[k]).view * *world));
                let b = seen(&pose(3.0), &(off[k] * given[k].view));
                (0..3).map(move |j| a[j].distance(b[j])).fold(0.0, f64::max)
            };
            (0..4).map(points).fold(0.0, f64::max)
        };
        let found = far(&own, &DAffine3::IDENTITY);
        assert!(found < 2e-3, "{found} m");
        // What they share is taken out, and nothing else.
        let before = own.camera(0, given[0]).view;
        own.center(&given);
        let world = own.camera(0, given[0]).view.inverse() * before;
        let still = far(&own, &world);
        assert!(still < 5e-3, "{still} m");
        assert!(far(&own, &DAffine3::IDENTITY) > 0.01);
        let mean: DVec3 = (0..4)
            .map(|k| given[k].view.matrix3.transpose() * DVec3::from_slice(own.cameras.item(k)))
            .sum();
        assert!(mean.length() < 1e-12);
    }
}
