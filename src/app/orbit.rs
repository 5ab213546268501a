//! The viewer's camera: it orbits around the avatar and glides to where gestures send it.

use crate::{gesture::Gesture, views::ViewTarget};
use effigy_core::scene::{Camera, Framing};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// Vertical field of view, radians.
const FOV: f64 = 35.0 * PI / 180.0;
/// The default view, radians: the front, a little from the avatar's left and from above.
const FRONT_YAW: f64 = 20.0 * PI / 180.0;
const FRONT_PITCH: f64 = 5.0 * PI / 180.0;
/// Largest pitch, radians: a view straight up or down has no left and right.
const PITCH_MAX: f64 = 89.0 * PI / 180.0;
/// Time constant of the glide, seconds: a movement has then covered 63 % of its way.
const SMOOTHING: f64 = 0.05;
/// The glide ends this close to its goal, radians or a fraction of the distance: far below a
/// pixel.
const ARRIVED: f64 = 1e-4;
/// Nearest and furthest distance from the target, in radii of the avatar.
const DISTANCE_MIN: f64 = 0.2;
const DISTANCE_MAX: f64 = 20.0;

/// Where the camera stands around its target.
#[derive(Clone, Copy, Debug, PartialEq)]
struct OrbitPose {
    /// From the anchor to the point that the camera looks at, metres.
    target: DVec3,
    /// Around the vertical axis, radians; 0 sees the front.
    yaw: f64,
    /// Above the horizon, radians.
    pitch: f64,
    /// From the target, metres.
    distance: f64,
}

impl OrbitPose {
    /// The camera's right, down and forward, in world coordinates.
    fn axes(&self) -> [DVec3; 3] {
        let camera = Camera::orbit(DVec3::ZERO, self.yaw, self.pitch, 1.0, FOV, [1, 1]);
        let rotation = camera.view.matrix3.transpose();
        [rotation.x_axis, rotation.y_axis, rotation.z_axis]
    }

    /// The pose a share `t` of the way to `goal`.
    fn interpolate(&self, goal: &Self, t: f64) -> Self {
        Self {
            target: self.target.lerp(goal.target, t),
            yaw: self.yaw + (goal.yaw - self.yaw) * t,
            pitch: self.pitch + (goal.pitch - self.pitch) * t,
            distance: self.distance * (goal.distance / self.distance).powf(t),
        }
    }

    /// Whether an image from here looks the same as one from `goal`.
    fn has_arrived(&self, goal: &Self) -> bool {
        (self.yaw - goal.yaw).abs() < ARRIVED
            && (self.pitch - goal.pitch).abs() < ARRIVED
            && (self.distance / goal.distance).ln().abs() < ARRIVED
            && self.target.distance(goal.target) < ARRIVED * goal.distance
    }
}

/// A camera that orbits, pans and zooms around a target, and glides to where gestures send it.
#[derive(Clone, Debug)]
pub struct OrbitCamera {
    goal: OrbitPose,
    shown: OrbitPose,
    /// The point that the target moves along with, metres, in world coordinates.
    anchor: DVec3,
    /// What the view had in it when it was last reset, metres from the anchor.
    framing: Framing,
    /// No gesture has changed the view since it was last reset.
    framed: bool,
    /// Who is in the box stands in it: see [`Camera::standing_distance`].
    stands: bool,
}

impl OrbitCamera {
    /// A view of all of a box in world coordinates, from the front. `anchor`: the point that the
    /// view follows. `size`: the image's, px.
    pub fn new(framing: impl Into<Framing>, anchor: DVec3, size: [u32; 2]) -> Self {
        let framing = framing.into();
        let front = OrbitPose {
            target: DVec3::ZERO,
            yaw: FRONT_YAW,
            pitch: FRONT_PITCH,
            distance: 1.0,
        };
        let mut orbit = Self {
            goal: front,
            shown: front,
            anchor,
            framing,
            framed: true,
            stands: false,
        };
        orbit.reset(framing, size);
        orbit.shown = orbit.goal;
        orbit
    }

    /// This view of a person, who stands in the box.
    pub fn of_person(mut self, size: [u32; 2]) -> Self {
        self.stands = true;
        self.resize(size);
        self
    }

    /// Glides back to a view of all of a box from the front.
    pub fn reset(&mut self, framing: impl Into<Framing>, size: [u32; 2]) {
        let framing = framing.into();
        let front = ViewTarget {
            bounds: framing.bounds,
            yaw: FRONT_YAW,
            pitch: FRONT_PITCH,
        };
        self.show(framing, &front, size);
        self.framed = true;
    }

    /// Glides to a sight of a part of a box, or of all of it.
    pub fn show(&mut self, framing: Framing, sight: &ViewTarget, size: [u32; 2]) {
        let from_anchor = |bounds: [DVec3; 2]| bounds.map(|corner| corner - self.anchor);
        self.framing = Framing {
            bounds: from_anchor(framing.bounds),
            ..framing
        };
        let part = from_anchor(sight.bounds);
        let yaw = sight.yaw;
        // The short way round.
        self.shown.yaw = yaw + (self.shown.yaw - yaw + PI).rem_euclid(TAU) - PI;
        self.goal = OrbitPose {
            target: 0.5 * (part[0] + part[1]),
            yaw,
            pitch: sight.pitch.clamp(-PITCH_MAX, PITCH_MAX),
            distance: if sight.pitch.abs() > 0.25 * PI {
                distance_above(part, size)
            } else {
                self.framing_distance(part, size)
            },
        };
        self.framed = false;
    }

    /// The image has a new size, px. A view that no gesture has changed still shows all of the
    /// avatar.
    pub fn resize(&mut self, size: [u32; 2]) {
        if self.framed {
            self.goal.distance = self.framing_distance(self.framing.bounds, size);
            self.shown.distance = self.goal.distance;
        }
    }

    /// The distance from which all in a box is visible, metres.
    fn framing_distance(&self, bounds: [DVec3; 2], size: [u32; 2]) -> f64 {
        let size = size.map(|side| side.max(1));
        let distance = if self.stands {
            Camera::standing_distance(bounds, FOV, size)
        } else {
            Camera::framing_distance(bounds, FOV, size)
        };
        distance.max(2.0 * self.framing.near)
    }

    /// Half the diagonal of the avatar's box, metres.
    fn radius(&self) -> f64 {
        let [min, max] = self.framing.bounds;
        (0.5 * min.distance(max)).max(self.framing.near)
    }

    /// Moves the anchor, metres. The view moves with it at once, without a glide.
    pub fn follow(&mut self, anchor: DVec3) {
        self.anchor = anchor;
    }

    /// Glides to a new anchor, metres.
    pub fn glide_to_anchor(&mut self, anchor: DVec3) {
        self.shown.target += self.anchor - anchor;
        self.anchor = anchor;
    }

    /// Applies a gesture, px of an image of this size.
    pub fn apply(&mut self, gesture: &Gesture, size: [u32; 2]) {
        if *gesture == Gesture::default() {
            return;
        }
        self.framed = false;
        let size = DVec2::new(f64::from(size[0].max(1)), f64::from(size[1].max(1)));
        let turn = gesture.orbit * PI / size.min_element();
        self.goal.yaw -= turn.x;
        self.goal.pitch = (self.goal.pitch + turn.y).clamp(-PITCH_MAX, PITCH_MAX);

        let metres_per_px = 2.0 * (0.5 * FOV).tan() * self.goal.distance / size.y;
        let [right, down, _] = self.goal.axes();
        let on_target_plane = |px: DVec2| (right * px.x + down * px.y) * metres_per_px;
        let radius = self.radius();
        let furthest = (DISTANCE_MAX * radius).max(self.goal.distance);
        let distance = (self.goal.distance * (-gesture.zoom).exp()).clamp(
            (DISTANCE_MIN * radius).max(2.0 * self.framing.near),
            furthest,
        );
        let about = gesture.about.map_or(DVec2::ZERO, |at| at - 0.5 * size);
        // What is beside the avatar is nothing to zoom to: the target stays.
        let about = Some(on_target_plane(about))
            .filter(|about| self.is_near(self.goal.target + *about))
            .unwrap_or_default();
        let target = self.goal.target - on_target_plane(gesture.pan)
            + about * (1.0 - distance / self.goal.distance);
        let [min, max] = self.framing.bounds;
        self.goal.target = target.clamp(min - radius, max + radius);
        self.goal.distance = distance;
    }

    /// Whether a point, metres from the anchor, is in the ellipsoid around the vertical axis that
    /// its box encloses: about where the avatar is.
    fn is_near(&self, point: DVec3) -> bool {
        let [min, max] = self.framing.bounds;
        let half = 0.5 * (max - min);
        let around = half.x.max(half.z);
        let within = DVec3::new(around, half.y, around).max(DVec3::splat(1e-9));
        ((point - 0.5 * (min + max)) / within).length_squared() <= 1.0
    }

    /// Lets `seconds` pass. Returns whether the view has moved. The path does not depend on how
    /// time is divided into frames.
    pub fn advance(&mut self, seconds: f64) -> bool {
        if self.shown == self.goal {
            return false;
        }
        self.shown = self
            .shown
            .interpolate(&self.goal, 1.0 - (-seconds.max(0.0) / SMOOTHING).exp());
        if self.shown.has_arrived(&self.goal) {
            self.shown = self.goal;
        }
        true
    }

    /// Whether the view has reached its goal.
    pub fn is_at_rest(&self) -> bool {
        self.shown == self.goal
    }

    /// The camera now, for an image of `size` px.
    pub fn camera(&self, size: [u32; 2]) -> Camera {
        let OrbitPose {
            target,
            yaw,
            pitch,
            distance,
        } = self.shown;
        Camera {
            near: self.framing.near,
            ..Camera::orbit(self.anchor + target, yaw, pitch, distance, FOV, size)
        }
    }
}

/// The distance over a box from which all of it is visible, metres.
fn distance_above([min, max]: [DVec3; 2], size: [u32; 2]) -> f64 {
    let half = 0.5 * (max - min);
    let footprint = DVec3::new(half.x, half.x.hypot(half.z), half.z);
    let size = size.map(|side| side.max(1));
    Camera::framing_distance([-footprint, footprint], FOV, size) + half.y
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: [DVec3; 2] = [DVec3::new(-0.8, 0.0, -0.2), DVec3::new(0.8, 1.8, 0.3)];

    fn at_rest(mut orbit: OrbitCamera) -> OrbitCamera {
        while orbit.advance(1.0 / 60.0) {}
        orbit
    }

    #[test]
    fn the_first_view_shows_all_of_the_avatar() {
        for size in [[1280, 720], [720, 1280], [4000, 100], [100, 4000], [1, 1]] {
            let camera = OrbitCamera::new(BOX, DVec3::ZERO, size).camera(size);
            let mut min = DVec2::INFINITY;
            let mut max = DVec2::NEG_INFINITY;
            for corner in
                (0..8).map(|k: usize| DVec3::new(BOX[k & 1].x, BOX[k >> 1 & 1].y, BOX[k >> 2].z))
            {
                let at = camera.project(camera.view.transform_point3(corner))
                    / DVec2::new(f64::from(size[0]), f64::from(size[1]));
                min = min.min(at);
                max = max.max(at);
            }
            assert!(
                min.min_element() >= 0.0 && max.max_element() <= 1.0,
                "{size:?}: {min} to {max} of the image"
            );
            assert!(
                (max - min).max_element() > 0.6,
                "{size:?}: the avatar fills only {} of the image",
                max - min
            );
        }
    }

    #[test]
    fn the_path_is_independent_of_the_frame_rate() {
        let start = OrbitCamera::new(BOX, DVec3::ZERO, [800, 600]);
        let at = |frames: u32| {
            let mut orbit = start.clone();
            orbit.apply(
                &Gesture {
                    orbit: DVec2::new(120.0, 40.0),
                    zoom: 0.7,
                    ..Gesture::default()
                },
                [800, 600],
            );
            for _ in 0..frames {
                orbit.advance(0.08 / f64::from(frames));
            }
            orbit.camera([800, 600]).eye()
        };
        for frames in [1, 2, 5, 40] {
            assert!(
                at(frames).distance(at(10)) < 1e-9,
                "{frames} frames: {} against {}",
                at(frames),
                at(10)
            );
        }
    }

    #[test]
    fn a_gesture_moves_the_view_until_it_rests() {
        let mut orbit = OrbitCamera::new(BOX, DVec3::ZERO, [800, 600]);
        assert!(orbit.is_at_rest() && !orbit.advance(0.1));
        orbit.apply(
            &Gesture {
                orbit: DVec2::new(300.0, 0.0),
                ..Gesture::default()
            },
            [800, 600],
        );
        assert!(orbit.advance(0.01));
        let orbit = at_rest(orbit);
        let eye = orbit.camera([800, 600]).eye();
        let seen_from = (eye.x - orbit.goal.target.x).atan2(eye.z - orbit.goal.target.z);
        let expected = FRONT_YAW - 0.5 * PI;
        assert!(
            (seen_from - expected).abs() < 1e-9,
            "half the window's height is a quarter turn: {seen_from} instead of {expected}"
        );
    }

    #[test]
    fn pitch_stops_short_of_the_poles() {
        for down in [1e5, -1e5] {
            let mut orbit = OrbitCamera::new(BOX, DVec3::ZERO, [800, 600]);
            orbit.apply(
                &Gesture {
                    orbit: DVec2::new(0.0, down),
                    ..Gesture::default()
                },
                [800, 600],
            );
            let camera = at_rest(orbit).camera([800, 600]);
            assert!(camera.view.is_finite());
            assert!(
                (camera.view.matrix3.transpose().z_axis.y + PITCH_MAX.sin() * down.signum()).abs()
                    < 1e-9
            );
        }
    }

    #[test]
    fn zoom_keeps_the_point_under_the_pointer_within_limits() {
        let size = [800, 600];
        let pointer = DVec2::new(500.0, 150.0);
        let start = OrbitCamera::new(BOX, DVec3::ZERO, size);
        let before = start.camera(size);
        let depth = start.goal.distance;
        let ray = ((pointer - before.center) / before.focal).extend(1.0) * depth;
        let point = before.view.inverse().transform_point3(ray);
        for zoom in [0.5, -0.5] {
            let mut orbit = start.clone();
            orbit.apply(
                &Gesture {
                    zoom,
                    about: Some(pointer),
                    ..Gesture::default()
                },
                size,
            );
            let camera = at_rest(orbit).camera(size);
            let now = camera.project(camera.view.transform_point3(point));
            assert!(
                now.distance(pointer) < 1e-6,
                "zoom {zoom}: {now} instead of {pointer}"
            );
        }
        for zoom in [100.0, -100.0, f64::MAX] {
            let mut orbit = start.clone();
            orbit.apply(
                &Gesture {
                    zoom,
                    ..Gesture::default()
                },
                size,
            );
            let nearest = DISTANCE_MIN * orbit.radius();
            let furthest = DISTANCE_MAX * orbit.radius();
            assert!(
                (nearest..=furthest).contains(&orbit.goal.distance),
                "zoom {zoom}: {}",
                orbit.goal.distance
            );
        }
    }

    #[test]
    fn zooming_beside_the_avatar_keeps_it_in_the_middle() {
        let size = [800, 600];
        for pointer in [
            DVec2::new(2.0, 2.0),
            DVec2::new(790.0, 300.0),
            DVec2::new(60.0, 580.0),
        ] {
            let mut orbit = OrbitCamera::new(BOX, DVec3::ZERO, size);
            let target = orbit.goal.target;
            for notches in [2.0, -3.0, 1.0] {
                orbit.apply(
                    &Gesture {
                        zoom: 0.12 * notches,
                        about: Some(pointer),
                        ..Gesture::default()
                    },
                    size,
                );
            }
            assert_eq!(orbit.goal.target, target, "{pointer}");
        }
    }

    #[test]
    fn a_sight_of_a_part_is_near_and_not_undone_by_a_new_size() {
        let size = [800, 600];
        let head = [DVec3::new(-0.1, 1.5, -0.1), DVec3::new(0.1, 1.8, 0.1)];
        let mut orbit = OrbitCamera::new(BOX, DVec3::ZERO, size);
        let whole = orbit.goal.distance;
        let sight = ViewTarget {
            bounds: head,
            yaw: 3.0 * PI,
            pitch: PI,
        };
        orbit.show(BOX.into(), &sight, size);
        orbit.resize([300, 600]);
        let orbit = at_rest(orbit);
        assert!(orbit.shown.distance < 0.3 * whole);
        assert_eq!(orbit.shown.target, DVec3::new(0.0, 1.65, 0.0));
        assert_eq!(orbit.shown.pitch, PITCH_MAX);
    }

    #[test]
    fn panning_follows_the_pointer_within_limits() {
        let size = [800, 600];
        let mut orbit = OrbitCamera::new(BOX, DVec3::ZERO, size);
        let target = orbit.goal.target;
        orbit.apply(
            &Gesture {
                pan: DVec2::new(50.0, -20.0),
                ..Gesture::default()
            },
            size,
        );
        let camera = at_rest(orbit.clone()).camera(size);
        let now = camera.project(camera.view.transform_point3(target));
        assert!(now.distance(DVec2::new(450.0, 280.0)) < 1e-6, "{now}");
        for _ in 0..100 {
            orbit.apply(
                &Gesture {
                    pan: DVec2::splat(500.0),
                    ..Gesture::default()
                },
                size,
            );
        }
        assert!(
            orbit.goal.target.distance(target) < 4.0 * orbit.radius(),
            "{}",
            orbit.goal.target
        );
    }

    #[test]
    fn reset_takes_the_short_way_back_to_the_front() {
        let size = [800, 600];
        let mut orbit = OrbitCamera::new(BOX, DVec3::ZERO, size);
        let first = orbit.camera(size);
        orbit.apply(
            &Gesture {
                orbit: DVec2::new(5000.0, 90.0),
                pan: DVec2::splat(30.0),
                zoom: 1.0,
                about: None,
            },
            size,
        );
        orbit = at_rest(orbit);
        orbit.reset(BOX, size);
        assert!(
            (orbit.shown.yaw - FRONT_YAW).abs() <= PI,
            "{} is more than half a turn away",
            orbit.shown.yaw
        );
        assert_eq!(at_rest(orbit).camera(size), first);
    }

    #[test]
    fn the_view_follows_the_anchor() {
        let size = [640, 480];
        let mut orbit = OrbitCamera::new(BOX, DVec3::ZERO, size);
        let before = orbit.camera(size).eye();
        orbit.follow(DVec3::new(3.0, 0.0, -1.0));
        assert!(
            orbit
                .camera(size)
                .eye()
                .distance(before + DVec3::new(3.0, 0.0, -1.0))
                < 1e-12
        );
        orbit.glide_to_anchor(DVec3::new(-1.0, 0.0, 0.0));
        assert!(
            orbit
                .camera(size)
                .eye()
                .distance(before + DVec3::new(3.0, 0.0, -1.0))
                < 1e-12,
            "it glides to a new anchor"
        );
        assert!(
            at_rest(orbit)
                .camera(size)
                .eye()
                .distance(before + DVec3::new(-1.0, 0.0, 0.0))
                < 1e-12
        );
    }

    #[test]
    fn views_of_a_scene_are_alike_in_every_unit() {
        let size = [800, 600];
        let after = |scale: f64, zoom: f64| {
            let framing = Framing::scene(BOX.map(|corner| scale * corner));
            let mut orbit = OrbitCamera::new(framing, DVec3::ZERO, size);
            for _ in 0..3 {
                orbit.apply(
                    &Gesture {
                        zoom,
                        pan: DVec2::splat(900.0),
                        ..Gesture::default()
                    },
                    size,
                );
            }
            at_rest(orbit).camera(size)
        };
        for zoom in [0.0, 0.3, 100.0, -100.0] {
            let [one, tenth] = [1.0, 0.1].map(|scale| after(scale, zoom));
            assert!(tenth.near < one.near && one.near <= Camera::NEAR);
            for scale in [1e-3, 0.01, 0.1, 100.0] {
                let other = after(scale, zoom);
                let off = (other.eye() / scale).distance(one.eye());
                assert!(off < 1e-6, "{scale}: {off}");
                // No further than from a person.
                let near = (10.0 * scale * tenth.near).min(Camera::NEAR);
                assert!((other.near - near).abs() < 1e-9, "{scale}: {}", other.near);
            }
        }
    }

    #[test]
    fn an_unchanged_view_is_framed_again_after_a_resize() {
        let mut orbit = OrbitCamera::new(BOX, DVec3::ZERO, [1280, 720]);
        orbit.resize([200, 900]);
        assert_eq!(
            orbit.camera([200, 900]),
            OrbitCamera::new(BOX, DVec3::ZERO, [200, 900]).camera([200, 900])
        );
        orbit.apply(
            &Gesture {
                zoom: 0.1,
                ..Gesture::default()
            },
            [200, 900],
        );
        let distance = orbit.goal.distance;
        orbit.resize([1280, 720]);
        assert_eq!(orbit.goal.distance, distance);
    }
}
