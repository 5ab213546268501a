//! The cases, and what each draws: a task and a setting go in, the scene of every frame comes out.
//!
//! [`BenchCase::Full`] jumps through the clip and around the avatar, so that no frame resembles the
//! one before. The other moving cases run in real time at [`RATE`], as in a viewer, but in takes of
//! [`TAKE`] frames from places spread over the clip, each from another side: so even a short run
//! measures more than one step seen from one side. A zoom has no takes.

use crate::{
    in_rows,
    setting::RenderSetting,
    viewpoint::{self, FOV, PITCH},
};
use effigy_core::{
    avatar::{Avatar, Pose, motion::Player},
    frame::Skip,
    scene::{AvatarBounds, Camera, Framing, Posed},
};
use glam::DVec3;
use std::{
    borrow::Cow,
    f64::consts::TAU,
    fmt,
    ops::{Range, RangeInclusive},
    str::FromStr,
};

/// Frames a second in real time.
pub const RATE: f64 = 60.0;
/// Frames from one cut to the next.
pub const TAKE: usize = 12;

/// Angle of a slow orbit, radians a frame: half a degree.
const ORBIT_STEP: f64 = TAU / 720.0;
/// Distance from the camera to the face in a close-up, metres: a forearm.
const FOREARM: f64 = 0.45;

/// How tall a small avatar is whose case names no height, px.
const FAR: u16 = 60;
/// Heights that such a case may have, px.
const FAR_HEIGHTS: RangeInclusive<u16> = 8..=2000;
/// Height of an avatar in the images that their truth is averaged from, px, where 3 to 8 samples a
/// pixel allow it.
const TRUTH_HEIGHT: f64 = 3840.0;

/// Height of the avatar in the first and last frame of a zoom, px, in an image that has room for
/// it.
const ZOOM: [f64; 2] = [2000.0, 20.0];
/// Most of an image's height that it takes.
const ZOOM_SHARE: f64 = 0.98;

/// A table of the cases: variant, name on the command line and in reports, what it draws.
macro_rules! cases {
    ($($case:ident $name:literal $about:literal)*) => {
        /// A scripted scene that a benchmark draws.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum BenchCase {
            $(#[doc = $about] $case,)*
            /// Motion in real time, the avatar so many px tall in the image.
            Far(u16),
        }

        impl BenchCase {
            /// Every case, small avatars of some heights.
            pub const ALL: &[Self] = &[
                $(Self::$case,)*
                Self::Far(30),
                Self::Far(FAR),
                Self::Far(120),
                Self::Far(240),
                Self::Far(480),
            ];

            /// Name on the command line and in reports.
            pub fn name(self) -> Cow<'static, str> {
                match self {
                    $(Self::$case => $name.into(),)*
                    Self::Far(FAR) => "far".into(),
                    Self::Far(height) => format!("far{height}").into(),
                }
            }

            /// One line on what it draws.
            pub fn about(self) -> Cow<'static, str> {
                match self {
                    $(Self::$case => $about.into(),)*
                    Self::Far(height) => {
                        format!("motion in real time, the avatar {height} px tall").into()
                    }
                }
            }
        }
    };
}

cases! {
    Full "full" "every frame a new pose and the next view"
    Camera "camera" "a still avatar, a slowly orbiting camera"
    Orbit "orbit" "motion in real time, a slowly orbiting camera"
    Expression "expression" "only the expression changes"
    Static "static" "nothing changes"
    Close "close" "motion in real time, the camera a forearm from the face"
    Four "four" "four avatars in motion a metre apart, a slowly orbiting camera on all or one of them"
    Crowd "crowd" "64 avatars in motion, about 60 px tall if they fit, a slowly orbiting camera"
    Flicker "flicker" "motion in real time, a slowly orbiting camera; what flickers"
    Zoom "zoom" "a still avatar that grows smaller, from 2000 to 20 px; what flickers"
}

impl BenchCase {
    /// Number of avatars in its scenes.
    pub fn instances(self) -> usize {
        match self {
            Self::Four => 4,
            Self::Crowd => 64,
            _ => 1,
        }
    }

    /// Whether frames follow each other at [`RATE`], so that a pose can be held
    /// for several of them.
    pub fn in_real_time(self) -> bool {
        matches!(self, Self::Orbit | Self::Close | Self::Four | Self::Flicker)
            || self.tall().is_some()
    }

    /// Whether the flicker of its frames is measured.
    pub fn has_flicker(self) -> bool {
        matches!(self, Self::Flicker | Self::Zoom)
    }

    /// How tall the avatar is in the image, px, where the case says so.
    pub fn tall(self) -> Option<f64> {
        match self {
            Self::Far(height) => Some(height.into()),
            Self::Crowd => Some(FAR.into()),
            _ => None,
        }
    }

    /// How many times its size the reference draws it, before it is averaged. What is small is
    /// compared with what the area of each pixel shows.
    pub fn truth_factor(self) -> u32 {
        match self.tall() {
            // Of taller ones fewer samples tell as much.
            Some(tall) => (TRUTH_HEIGHT / tall).clamp(3.0, 8.0) as u32,
            None => 1,
        }
    }

    /// Frames to draw unless the user says otherwise. `sweep`: in each round of a sweep.
    pub fn default_frames(self, sweep: bool) -> usize {
        match self {
            Self::Zoom => 200,
            Self::Flicker => 2 * TAKE,
            _ if sweep => 24,
            _ => 48,
        }
    }

    /// Whether the camera moves.
    fn camera_moves(self) -> bool {
        !matches!(self, Self::Static | Self::Expression)
    }

    /// Whether the case keeps its own camera even if cameras are given.
    fn own_camera(self) -> bool {
        matches!(self, Self::Close | Self::Four | Self::Zoom) || self.tall().is_some()
    }
}

impl RenderSetting {
    /// The setting as a case is drawn with it. In [`BenchCase::Full`] every frame is drawn, even if
    /// nothing has changed.
    pub fn for_case(&self, case: BenchCase) -> Self {
        let mut setting = *self;
        if case == BenchCase::Full {
            setting.options.skip -= Skip::FRAME;
        }
        setting
    }
}

impl fmt::Display for BenchCase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name())
    }
}

impl FromStr for BenchCase {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if let Some(case) = Self::ALL.iter().find(|case| case.name() == text) {
            return Ok(*case);
        }
        let height = text.strip_prefix("far").and_then(|text| text.parse().ok());
        if let Some(height) = height.filter(|height| FAR_HEIGHTS.contains(height)) {
            return Ok(Self::Far(height));
        }
        let names: Vec<_> = Self::ALL.iter().map(|case| case.name()).collect();
        Err(format!(
            "`{text}` is not a case: write one of {}, or far and a height from {} to {} px",
            names.join(", "),
            FAR_HEIGHTS.start(),
            FAR_HEIGHTS.end()
        ))
    }
}

/// What a benchmark draws, and how much of it is compared with the reference.
#[derive(Clone, Copy)]
pub struct BenchTask<'a> {
    /// The avatar of every instance, with all its rows.
    pub avatar: &'a Avatar,
    /// The clips that move it, at least one: cases draw the first, the spread draws all.
    pub clips: &'a [Player],
    /// Cameras for images of the setting's size, one for each frame in turn, in place of those
    /// around the avatar; may be empty. Some cases keep their own.
    pub cameras: &'a [Camera],
    /// Frames to time, at least 1; [`BenchCase::default_frames`] if not given.
    pub frames: Option<usize>,
    /// Views around the avatar, used in turn, at least 1.
    pub views: usize,
    /// How many of the frames to compare with the reference.
    pub checked: usize,
    /// Whether to compute FLIP of them too.
    pub flip: bool,
    /// Poses of each clip in the spread.
    pub spread: usize,
}

/// One avatar of a scene.
#[derive(Clone, Debug)]
pub struct PosedInstance {
    /// The pose to draw.
    pub drawn: Posed,
    /// The pose to compare with: that of the clip at this time. It differs while a pose is held.
    pub reference: Posed,
}

/// The contents of one frame.
#[derive(Clone, Debug)]
pub struct BenchScene {
    /// At least one. All of them are copies of one avatar.
    pub instances: Vec<PosedInstance>,
    /// Where all of them are seen from.
    pub camera: Camera,
}

/// The scenes of a case, one a frame. `sweep`: of a sweep's rounds.
pub fn scenes(
    case: BenchCase,
    task: &BenchTask,
    setting: &RenderSetting,
    sweep: bool,
) -> Vec<BenchScene> {
    let script = Script::new(case, task, setting, sweep);
    (0..script.frames)
        .map(|frame| script.scene(frame))
        .collect()
}

/// Which of `frames` scenes to compare with the reference: `count` of them, spread over the run and
/// over the views; while poses are held, at the end of the hold rather than at its start.
pub fn checks(case: BenchCase, frames: usize, count: usize) -> Vec<usize> {
    let count = count.min(frames);
    let last = |check: usize| (check + 1) * frames / count - 1;
    // One frame earlier each time, for another view. Between takes the view changes anyway.
    let shift = |check: usize| {
        if case == BenchCase::Full {
            check % (frames / count)
        } else {
            0
        }
    };
    (0..count).map(|check| last(check) - shift(check)).collect()
}

/// A case with what it is drawn from.
struct Script<'a> {
    case: BenchCase,
    task: &'a BenchTask<'a>,
    player: &'a Player,
    /// Of the image, px.
    size: [u32; 2],
    frames: usize,
    /// Frames that each pose is held for. Only for motion in real time.
    hold: usize,
    bounds: AvatarBounds,
}

impl<'a> Script<'a> {
    fn new(case: BenchCase, task: &'a BenchTask<'a>, setting: &RenderSetting, sweep: bool) -> Self {
        Self {
            case,
            task,
            player: &task.clips[0],
            size: setting.options.size,
            frames: task.frames.unwrap_or(case.default_frames(sweep)),
            hold: setting.hold,
            bounds: AvatarBounds::new(task.avatar),
        }
    }

    fn scene(&self, frame: usize) -> BenchScene {
        let drawn_frame = if self.case.in_real_time() {
            frame - frame % TAKE % self.hold
        } else {
            frame
        };
        let instances = (0..self.case.instances()).map(|instance| PosedInstance {
            drawn: self.posed(drawn_frame, instance),
            reference: self.posed(frame, instance),
        });
        let cameras = self.task.cameras;
        let camera = if self.case.own_camera() || cameras.is_empty() {
            self.camera(frame)
        } else if self.case.camera_moves() {
            cameras[frame % cameras.len()]
        } else {
            cameras[0]
        };
        BenchScene {
            instances: instances.collect(),
            camera,
        }
    }

    /// How tall the avatar is in the image, px, where the case says so.
    fn tall(&self, frame: usize) -> Option<f64> {
        if self.case != BenchCase::Zoom {
            return self.case.tall();
        }
        let [first, last] = ZOOM.map(|tall| tall.min(ZOOM_SHARE * f64::from(self.size[1])));
        let share = frame as f64 / (self.frames.max(2) - 1) as f64;
        Some(first * (last / first).powf(share))
    }

    /// Time in the clip, seconds. Static cases stay in its middle.
    fn seconds(&self, frame: usize) -> f64 {
        let duration = self.player.clip().duration();
        match self.case {
            BenchCase::Full => duration * frame as f64 / self.frames as f64,
            BenchCase::Camera | BenchCase::Expression | BenchCase::Static | BenchCase::Zoom => {
                0.5 * duration
            }
            _ => {
                let takes = self.frames.div_ceil(TAKE);
                let start =
                    (duration - TAKE as f64 / RATE).max(0.0) * (frame / TAKE) as f64 / takes as f64;
                start + (frame % TAKE) as f64 / RATE
            }
        }
    }

    /// The pose of an instance in a frame. Each instance is at another time of the clip.
    fn pose(&self, frame: usize, instance: usize) -> Pose {
        let duration = self.player.clip().duration();
        let offset = duration * instance as f64 / self.case.instances() as f64;
        let mut clip_time = self.seconds(frame) + offset;
        if offset > 0.0 {
            clip_time %= duration;
        }
        let mut pose = self.player.pose(clip_time);
        if self.case == BenchCase::Expression {
            // Clips of bodies have no expression: slow waves of one deviation, each component at
            // its own rate.
            let wave = |k: usize| {
                let cycles = frame as f64 / 40.0 * (1 + k % 3) as f64 + 0.1 * k as f64;
                (TAU * cycles).sin()
            };
            pose.expression = (0..self.task.avatar.inputs.expression).map(wave).collect();
        }
        pose
    }

    fn posed(&self, frame: usize, instance: usize) -> Posed {
        Posed::new(self.task.avatar, &self.pose(frame, instance))
            .placed(in_rows(instance, self.case.instances()))
    }

    fn camera(&self, frame: usize) -> Camera {
        let case = self.case;
        if case == BenchCase::Close {
            return self.close_up(frame);
        }
        // Within a take the camera does not follow the avatar's steps.
        let framed = match case {
            BenchCase::Full => frame,
            BenchCase::Zoom => 0,
            _ => frame - frame % TAKE,
        };
        let own = |instance| self.bounds.framing(&self.posed(framed, instance).joints);
        let framing = self
            .framed_instances(frame)
            .map(own)
            .reduce(Framing::union)
            .unwrap_or_else(|| own(0));
        let [min, max] = framing.bounds;
        let views = self.task.views;
        let view = match case {
            BenchCase::Full => frame % views,
            BenchCase::Static | BenchCase::Expression | BenchCase::Zoom => 0,
            _ => frame / TAKE % views,
        };
        let orbit = if matches!(case, BenchCase::Full | BenchCase::Zoom) || !case.camera_moves() {
            0.0
        } else {
            ORBIT_STEP * (frame % TAKE) as f64
        };
        let mut distance = Camera::framing_distance([min, max], FOV, self.size);
        if let Some(tall) = self.tall(frame) {
            let focal = 0.5 * f64::from(self.size[1]) / (0.5 * FOV).tan();
            let asked = focal * (max.y - min.y) / tall;
            distance = if case == BenchCase::Zoom {
                asked
            } else {
                distance.max(asked)
            };
        }
        let yaw = viewpoint::yaw_of_view(view, views) + orbit;
        Camera {
            near: framing.near,
            ..Camera::orbit(framing.middle(), yaw, PITCH, distance, FOV, self.size)
        }
    }

    /// The instances that the camera frames. Of a few, every other take frames only the first, so
    /// that the others are partly or wholly outside the image.
    fn framed_instances(&self, frame: usize) -> Range<usize> {
        let all = self.case.instances();
        if self.case != BenchCase::Crowd && (frame / TAKE).is_multiple_of(2) {
            0..all.div_ceil(4)
        } else {
            0..all
        }
    }

    /// A camera straight in front of the face: of the joint `head`, or else of the upper end of the
    /// bounds.
    fn close_up(&self, frame: usize) -> Camera {
        let pose = self.pose(frame, 0);
        let avatar = self.task.avatar;
        let skeleton = &avatar.skeleton;
        let is_head = |name: &String| name.eq_ignore_ascii_case("head");
        let face;
        let forward;
        if let Some(head) = skeleton.name.iter().position(is_head) {
            let rotation = skeleton.matrices(&pose)[head].matrix3;
            let joint = skeleton.joints(&pose)[head].translation;
            face = joint + rotation * DVec3::new(0.0, 0.06, 0.08);
            forward = rotation * DVec3::Z;
        } else {
            let [min, max] = self.bounds.bounds(&Posed::new(avatar, &pose).joints);
            face = DVec3::new((min.x + max.x) / 2.0, max.y - 0.15, (min.z + max.z) / 2.0);
            forward = DVec3::Z;
        }
        Camera::look_at(face + FOREARM * forward, face, FOV, self.size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::frame::RendererOptions;
    use std::collections::BTreeSet;

    const SIZE: [u32; 2] = [200, 240];

    fn with_demo(frames: usize, test: impl Fn(BenchTask)) {
        let avatar = effigy_demo::avatar().expect("inside the program");
        let clip = effigy_demo::clip().expect("inside the program");
        test(BenchTask {
            avatar: &avatar,
            clips: &[Player::new(clip, &avatar.skeleton)],
            cameras: &[],
            frames: Some(frames),
            views: 4,
            checked: 0,
            flip: false,
            spread: 0,
        });
    }

    fn setting(size: [u32; 2], hold: usize) -> RenderSetting {
        RenderSetting {
            hold,
            ..RenderSetting::new(RendererOptions::new(size))
        }
    }

    fn scenes_of(
        case: BenchCase,
        task: &BenchTask,
        size: [u32; 2],
        hold: usize,
    ) -> Vec<BenchScene> {
        scenes(case, task, &setting(size, hold), false)
    }

    #[test]
    fn cases_read_back_as_they_are_written() {
        for &case in BenchCase::ALL {
            assert_eq!(case.to_string().parse(), Ok(case));
        }
        let error = "fulll".parse::<BenchCase>();
        assert!(error.is_err_and(|error| error.contains("orbit")));
    }

    #[test]
    fn each_case_changes_only_what_it_names() {
        with_demo(24, |task| {
            // Whether joints, network input and camera change from each frame to the next.
            let changes = |case| {
                let scenes = scenes_of(case, &task, SIZE, 1);
                let all = |same: fn(&BenchScene, &BenchScene) -> bool| {
                    scenes.windows(2).all(|pair| !same(&pair[0], &pair[1]))
                };
                [
                    all(|a, b| a.instances[0].drawn.joints == b.instances[0].drawn.joints),
                    all(|a, b| a.instances[0].drawn.input == b.instances[0].drawn.input),
                    all(|a, b| a.camera == b.camera),
                ]
            };
            assert_eq!(changes(BenchCase::Full), [true; 3]);
            assert_eq!(changes(BenchCase::Orbit), [true; 3]);
            assert_eq!(changes(BenchCase::Flicker), [true; 3]);
            assert_eq!(changes(BenchCase::Camera), [false, false, true]);
            assert_eq!(changes(BenchCase::Zoom), [false, false, true]);
            assert_eq!(changes(BenchCase::Expression), [false, true, false]);
            let still = scenes_of(BenchCase::Static, &task, SIZE, 1);
            let is_first = |scene: &BenchScene| {
                scene.instances[0].drawn.joints == still[0].instances[0].drawn.joints
                    && scene.instances[0].drawn.input == still[0].instances[0].drawn.input
                    && scene.camera == still[0].camera
            };
            assert!(still.iter().all(is_first));
        });
    }

    #[test]
    fn far_avatars_and_close_faces_have_their_distance() {
        with_demo(12, |task| {
            let bounds = |scene: &BenchScene| {
                let joints = &scene.instances[0].drawn.joints;
                AvatarBounds::new(task.avatar).framing(joints).bounds
            };
            let height = |case, size| {
                let scene = &scenes_of(case, &task, size, 1)[0];
                let [min, max] = bounds(scene);
                let middle = (min + max) / 2.0;
                let at = |y| {
                    let point = DVec3::new(middle.x, y, middle.z);
                    let camera = &scene.camera;
                    camera.project(camera.view.transform_point3(point)).y
                };
                at(min.y) - at(max.y)
            };
            // A crowd needs more room, and some of it stands nearer.
            let of_the_crowd = height(BenchCase::Crowd, [2048; 2]);
            assert!((45.0..65.0).contains(&of_the_crowd), "{of_the_crowd}");
            let single = BenchCase::ALL.iter().filter(|case| case.instances() == 1);
            for &case in single {
                if let Some(tall) = case.tall().filter(|tall| *tall < 200.0) {
                    let height = height(case, SIZE);
                    assert!((height - tall).abs() < 2.0, "{case}: {height}");
                }
            }
            assert!(height(BenchCase::Orbit, SIZE) > 120.0);
            let zoom = scenes_of(BenchCase::Zoom, &task, SIZE, 1);
            let distances: Vec<f64> = zoom
                .iter()
                .map(|scene| {
                    let middle = bounds(scene).into_iter().sum::<DVec3>() / 2.0;
                    scene.camera.eye().distance(middle)
                })
                .collect();
            // 235 px at first, 20 at last, and each frame smaller than the last by one factor.
            let ratio = (ZOOM_SHARE * 240.0 / 20.0).powf(1.0 / 11.0);
            for pair in distances.windows(2) {
                assert!((pair[1] / pair[0] - ratio).abs() < 1e-9, "{distances:?}");
            }
            let names = &task.avatar.skeleton.name;
            let head = names
                .iter()
                .position(|name| name.eq_ignore_ascii_case("head"));
            let head = head.expect("the demo has a head");
            let script = Script::new(BenchCase::Close, &task, &setting(SIZE, 1), false);
            for frame in 0..12 {
                let scene = script.scene(frame);
                let joint = task.avatar.skeleton.joints(&script.pose(frame, 0))[head].translation;
                let view_space = scene.camera.view.transform_point3(joint);
                let at = scene.camera.project(view_space);
                assert!(
                    (FOREARM..FOREARM + 0.2).contains(&view_space.z),
                    "{view_space}"
                );
                assert!(
                    (0.0..200.0).contains(&at.x) && (0.0..240.0).contains(&at.y),
                    "{at}"
                );
            }
        });
    }

    #[test]
    fn a_pose_is_held_while_the_reference_moves_on() {
        with_demo(24, |task| {
            let scenes = scenes_of(BenchCase::Orbit, &task, SIZE, 3);
            for (frame, scene) in scenes.iter().enumerate() {
                let own = &scene.instances[0];
                let held = &scenes[frame - frame % 3].instances[0].reference;
                assert_eq!(own.drawn.joints, held.joints, "frame {frame}");
                let is_now = own.drawn.joints == own.reference.joints;
                assert_eq!(is_now, frame % 3 == 0, "frame {frame}");
            }
            let checks = checks(BenchCase::Orbit, 24, 2);
            assert!(checks.iter().all(|frame| frame % 3 == 2), "{checks:?}");
        });
    }

    #[test]
    fn four_avatars_stand_apart_and_move_differently() {
        with_demo(2 * TAKE, |task| {
            let scenes = scenes_of(BenchCase::Four, &task, SIZE, 1);
            let bounds = AvatarBounds::new(task.avatar);
            let in_view = |scene: &BenchScene| {
                let is_visible = |own: &&PosedInstance| {
                    let visible = bounds.visible(&own.drawn.joints, &scene.camera);
                    !visible.parts.is_empty()
                };
                scene.instances.iter().filter(is_visible).count()
            };
            let visible = [in_view(&scenes[0]), in_view(&scenes[TAKE])];
            assert!(visible[0] < 4 && visible[1] == 4, "{visible:?}");
            let stand = |instance: &PosedInstance| {
                let bounds = bounds.bounds(&instance.drawn.joints);
                bounds.into_iter().sum::<DVec3>() / 2.0
            };
            for pair in scenes[0].instances.windows(2) {
                let apart = (stand(&pair[1]) - stand(&pair[0])).length();
                assert!(
                    apart > 0.4 && pair[0].drawn.input != pair[1].drawn.input,
                    "{apart} m"
                );
            }
        });
    }

    #[test]
    fn given_cameras_are_used_in_turn() {
        with_demo(5, |task| {
            let camera = |k| Camera::orbit(DVec3::Y, f64::from(k), 0.0, 3.0, 0.5, SIZE);
            let cameras = [camera(0), camera(1)];
            let task = BenchTask {
                cameras: &cameras,
                ..task
            };
            let used = |case| {
                let own = |scene: &BenchScene| cameras.iter().position(|own| *own == scene.camera);
                let scenes = scenes_of(case, &task, SIZE, 1);
                scenes.iter().map(own).collect::<Vec<_>>()
            };
            let in_turn = [Some(0), Some(1), Some(0), Some(1), Some(0)];
            assert_eq!(used(BenchCase::Full), in_turn);
            assert_eq!(used(BenchCase::Static), [Some(0); 5]);
            assert_eq!(used(BenchCase::Close), [None; 5]);
        });
    }

    #[test]
    fn checked_frames_are_spread_and_show_every_view() {
        let checked = checks(BenchCase::Full, 32, 4);
        let views: BTreeSet<_> = checked.iter().map(|frame| frame % 4).collect();
        assert_eq!(views.len(), 4);
        for (frames, count) in [(1, 1), (3, 8), (32, 0), (10, 4), (5, 5)] {
            for &case in BenchCase::ALL {
                let checks = checks(case, frames, count);
                assert_eq!(checks.len(), count.min(frames), "{frames} frames");
                assert!(checks.is_sorted_by(|a, b| a < b), "{checks:?}");
                assert!(checks.iter().all(|&check| check < frames), "{checks:?}");
            }
        }
    }
}
