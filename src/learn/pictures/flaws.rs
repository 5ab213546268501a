//! What captures have and renderings don't: sensors, lenses, mattes, trackers and calibrations that
//! are a little off. Amounts of 0 change nothing.

use crate::pictures::image::LinearImage;
use effigy_capture::CaptureCamera;
use effigy_core::{
    avatar::{Pose, Skeleton},
    random::Random,
};
use effigy_math::noise::noise as smooth_noise;
use glam::{DAffine3, DQuat, DVec2, DVec3};

/// How far a capture is from what was there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Flaws {
    /// Standard deviation of a channel's noise, of 255.
    pub noise: f64,
    /// Standard deviation of a camera's exposure, stops; a third of it for each channel's balance.
    pub exposure: f64,
    /// Standard deviation of a camera's blur, px: half to one and a half times as much.
    pub blur: f64,
    /// How far a mask's edge may be off, px.
    pub mask: f64,
    /// Root mean square of a joint's turn away from its true pose, degrees.
    pub pose: f64,
    /// How far points of the person are off by a camera's calibration, root mean square, px.
    pub calibration: f64,
    /// Root mean square of how far joints of the body model are from the person's, mm: a shape that
    /// was fitted to somebody else.
    pub bone: f64,
}

/// What a camera does to its pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraLook {
    /// What linear red, green and blue are multiplied with.
    pub gain: DVec3,
    /// Standard deviation of the blur, px.
    pub blur: f64,
}

/// Streams of random numbers.
const GAIN: u64 = 0x6A1;
const CALIBRATION: u64 = 0xCA1 << 16;
const POSE: u64 = 0x905 << 32;
const BONE: u64 = 0xB0E << 40;

/// Joints whose poses trackers find: the body's, without fingers.
const TRACKED: usize = 22;
/// How large the waves of a mask's edge are, px.
const MASK_WAVE: f64 = 14.0;

impl Flaws {
    /// Those of a usual capture.
    pub const CAPTURED: Self = Self {
        noise: 3.0,
        exposure: 0.12,
        blur: 0.6,
        mask: 1.5,
        pose: 2.0,
        calibration: 1.0,
        bone: 0.0,
    };

    /// Whether all is as it was.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// What a camera, by index, does to its pictures.
    pub fn look(&self, camera: usize, seed: u64) -> CameraLook {
        let mut random = Random::new(seed, GAIN + camera as u64);
        let stops = self.exposure * random.normal();
        let mut channel = || 2f64.powf(stops + self.exposure / 3.0 * random.normal());
        CameraLook {
            gain: DVec3::new(channel(), channel(), channel()),
            blur: self.blur * random.range(0.5, 1.5),
        }
    }

    /// A camera as a calibration finds it. `index`: its own.
    pub fn calibrated(&self, camera: &CaptureCamera, index: usize, seed: u64) -> CaptureCamera {
        let mut found = camera.clone();
        if self.calibration == 0.0 {
            return found;
        }
        let mut random = Random::new(seed, CALIBRATION + index as u64);
        // Half of the variance from the optical axis, half from how the camera is turned; a turn
        // about that axis moves the picture's middle by nothing and its edge by about as much.
        let share = self.calibration / 2f64.sqrt();
        let turns = DVec3::new(random.normal(), random.normal(), random.normal());
        let turn = share / 2f64.sqrt() * turns / found.camera.focal.x;
        found.camera.center += share / 2f64.sqrt() * DVec2::new(random.normal(), random.normal());
        let turn = DAffine3::from_quat(DQuat::from_scaled_axis(turn));
        found.camera.view = turn * found.camera.view;
        found
    }

    /// A pose as a tracker finds it.
    pub fn tracked(&self, pose: &Pose, frame: usize, seed: u64) -> Pose {
        let mut found = pose.clone();
        if self.pose == 0.0 {
            return found;
        }
        let mut random = Random::new(seed, POSE + frame as u64);
        let axis = (self.pose / 3f64.sqrt()).to_radians();
        for turn in found.rotation.iter_mut().take(TRACKED) {
            let off = axis * DVec3::new(random.normal(), random.normal(), random.normal());
            let turned = DQuat::from_scaled_axis(*turn) * DQuat::from_scaled_axis(off);
            *turn = turned.normalize().to_scaled_axis();
        }
        found
    }

    /// The joints of the body model: fingers, toes and face move with the joint that carries them.
    pub fn fitted(&self, skeleton: &Skeleton, seed: u64) -> Skeleton {
        let mut random = Random::new(seed, BONE);
        let mut normal = || self.bone * 1e-3 / 3f64.sqrt() * random.normal();
        let bones: Vec<DVec3> = (0..skeleton.len())
            .map(|joint| match joint {
                0..TRACKED => DVec3::new(normal(), normal(), normal()),
                _ => DVec3::ZERO,
            })
            .collect();
        skeleton.with_bones(&bones)
    }

    /// Puts a camera's look and the mask's errors on a picture. `stream`: another for each picture.
    pub fn shoot(&self, image: &mut LinearImage, look: &CameraLook, stream: u64) {
        for light in &mut image.light {
            *light *= look.gain;
        }
        if look.blur > 0.0 {
            blur(image, look.blur);
        }
        if self.mask > 0.0 {
            wave(image, self.mask, stream);
        }
    }
}

/// A Gaussian blur of a picture's light.
fn blur(image: &mut LinearImage, sigma: f64) {
    let radius = (3.0 * sigma).ceil() as i64;
    let weight = |k: i64| (-0.5 * (k as f64 / sigma).powi(2)).exp();
    let sum: f64 = (-radius..=radius).map(weight).sum();
    let weights: Vec<f64> = (-radius..=radius).map(|k| weight(k) / sum).collect();
    let [width, height] = image.size.map(i64::from);
    for along_x in [true, false] {
        let before = image.light.clone();
        for (at, light) in image.light.iter_mut().enumerate() {
            let (x, y) = (at as i64 % width, at as i64 / width);
            let term = |(k, weight): (usize, &f64)| {
                let off = k as i64 - radius;
                let (x, y) = if along_x { (x + off, y) } else { (x, y + off) };
                let place = y.clamp(0, height - 1) * width + x.clamp(0, width - 1);
                before[place as usize] * *weight
            };
            *light = weights.iter().enumerate().map(term).sum();
        }
    }
}

/// Moves the mask's edge to and fro.
fn wave(image: &mut LinearImage, by: f64, stream: u64) {
    let before = image.coverage.clone();
    let [width, height] = image.size.map(|side| side as usize);
    let mut random = Random::new(stream, 0x3A5);
    let offset = DVec3::new(random.range(0.0, 1e3), random.range(0.0, 1e3), 0.0);
    let noise = |place: DVec3| {
        // Noise is mostly within ±0.5.
        (2.0 * by * smooth_noise(77, place)).clamp(-by, by)
    };
    for y in 0..height {
        for x in 0..width {
            let place = DVec3::new(x as f64, y as f64, 0.0) / MASK_WAVE + offset;
            let from_x = x as f64 + noise(place) + 0.5;
            let from_y = y as f64 + noise(place + DVec3::new(0.0, 0.0, 50.0)) + 0.5;
            let column = from_x.clamp(0.0, width as f64 - 1.0) as usize;
            let row = from_y.clamp(0.0, height as f64 - 1.0) as usize;
            image.coverage[y * width + x] = before[row * width + column];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::scene::Camera;

    fn camera() -> CaptureCamera {
        CaptureCamera {
            name: "cam00".into(),
            camera: Camera::look_at(DVec3::new(0.0, 1.0, 4.0), DVec3::Y, 0.5, [256, 256]),
            distortion: [0.0; 5],
            held: false,
        }
    }

    #[test]
    fn without_flaws_nothing_changes() {
        let none = Flaws::default();
        assert!(none.is_none());
        assert_eq!(none.calibrated(&camera(), 3, 1), camera());
        assert_eq!(none.look(3, 1).gain, DVec3::ONE);
        let pose = Pose::rest(30, 2);
        assert_eq!(none.tracked(&pose, 1, 1), pose);
    }

    #[test]
    fn poses_and_calibrations_are_off_by_what_was_asked_for() {
        let flaws = Flaws::CAPTURED;
        let mut squares = 0.0;
        let mut count = 0.0;
        for frame in 0..50 {
            let found = flaws.tracked(&Pose::rest(30, 0), frame, 7);
            assert!(
                found.rotation[TRACKED..]
                    .iter()
                    .all(|turn| *turn == DVec3::ZERO)
            );
            for turn in &found.rotation[..TRACKED] {
                squares += turn.length().to_degrees().powi(2);
                count += 1.0;
            }
        }
        let rms = f64::sqrt(squares / count);
        assert!((rms - 2.0).abs() < 0.15, "{rms} degrees");
        let mut squares = 0.0;
        let truth = camera();
        for index in 0..400 {
            let found = flaws.calibrated(&truth, index, 7);
            let point = DVec3::new(0.3, 1.5, 0.1);
            let place =
                |own: &CaptureCamera| own.camera.project(own.camera.view.transform_point3(point));
            squares += place(&found).distance_squared(place(&truth));
        }
        let rms = (squares / 400.0).sqrt();
        assert!((rms - 1.0).abs() < 0.15, "{rms} px");
    }

    #[test]
    fn joints_of_the_body_model_are_off_by_what_was_asked_for() {
        let count = TRACKED + 3;
        let skeleton = Skeleton {
            name: (0..count).map(|joint| joint.to_string()).collect(),
            parent: (0..count)
                .map(|joint| joint.checked_sub(1).map(|parent| parent as u8))
                .collect(),
            rest: (0..count).map(|joint| [0.1 * joint as f32; 3]).collect(),
            canonical: vec![[0.0; 3]; count],
        };
        assert_eq!(Flaws::default().fitted(&skeleton, 7), skeleton);
        let flaws = Flaws {
            bone: 15.0,
            ..Flaws::default()
        };
        assert!(!flaws.is_none());
        let mut squares = 0.0;
        let mut least = f64::MAX;
        for seed in 0..50 {
            let fitted = flaws.fitted(&skeleton, seed);
            assert_eq!(fitted.rest[0], skeleton.rest[0], "the root stays");
            let moved = |joint: usize| {
                let place = |own: &Skeleton| glam::Vec3::from(own.rest[joint]).as_dvec3();
                1e3 * (place(&fitted) - place(&skeleton))
            };
            for joint in 1..count {
                let bone = (moved(joint) - moved(joint - 1)).length();
                if joint < TRACKED {
                    squares += bone * bone;
                    least = least.min(bone);
                } else {
                    assert!(bone < 1e-3, "a finger is {bone} mm off in its hand");
                }
            }
        }
        let rms = f64::sqrt(squares / (50 * (TRACKED - 1)) as f64);
        assert!((rms - 15.0).abs() < 0.8, "{rms} mm");
        assert!(least > 0.0);
    }

    #[test]
    fn a_mask_moves_by_no_more_than_asked_for() {
        let mut image = LinearImage::empty([64, 64]);
        for (at, part) in image.coverage.iter_mut().enumerate() {
            *part = f32::from(at % 64 > 31);
        }
        wave(&mut image, 2.0, 9);
        let mut edges = std::collections::BTreeSet::new();
        for row in image.coverage.chunks(64) {
            assert!(row[..29].iter().all(|&part| part == 0.0));
            assert!(row[35..].iter().all(|&part| part == 1.0));
            edges.insert(row.iter().filter(|&&part| part == 1.0).count());
        }
        assert!(edges.len() > 1, "{edges:?}");
    }
}
