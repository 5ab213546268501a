//! The frames of a clip that `--frames` names, and what a camera holds in all of them.

use anyhow::ensure;
use effigy_core::{avatar::Clip, scene::Camera};
use glam::{DVec2, DVec3};
use std::ops::Range;

/// Time constant with which a camera goes along, seconds: two steps of a walk sway less than this
/// evens out.
const SMOOTHING: f64 = 0.3;
/// How far from the middle heads and feet reach, metres.
const TRUNK: f64 = 0.25;
/// The smoothing ends this many time constants away.
const REACH: f64 = 3.0;

/// Frames as a user names them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameRange {
    start: usize,
    /// Not included. None: to the clip's end.
    end: Option<usize>,
}

impl FrameRange {
    /// Reads `A..B`, at least one frame, `A..`, `..B` or `all`.
    pub fn parse(text: &str) -> Result<Self, String> {
        let number = |text: &str, without| match text {
            "" => Some(without),
            text => text.parse().ok().map(Some),
        };
        let range = if text == "all" {
            Some(Self {
                start: 0,
                end: None,
            })
        } else {
            text.split_once("..").and_then(|(start, end)| {
                Some(Self {
                    start: number(start, Some(0))??,
                    end: number(end, None)?,
                })
            })
        };
        range
            .filter(|range| range.end.is_none_or(|end| range.start < end))
            .ok_or_else(|| {
                format!(
                    "`{text}` is not a range of frames: write first..last+1, for instance 0..30, 10.., ..30, or all"
                )
            })
    }

    /// The frames of a clip, at least one. `rate`: frames a second, as which the clip has so many
    /// that none is behind its last.
    ///
    /// # Errors
    /// When it ends behind the clip.
    pub fn of(self, clip: &Clip, rate: f64) -> anyhow::Result<Range<usize>> {
        let frames = (clip.duration() * rate + 1e-6).floor() as usize + 1;
        let end = self.end.unwrap_or(frames);
        ensure!(
            self.start < end && end <= frames,
            "frames {}..{} were asked for; the clip `{}` has 0..{frames} at {rate} a second",
            self.start,
            self.end.map_or(String::new(), |end| end.to_string()),
            clip.name
        );
        Ok(self.start..end)
    }
}

/// Where those who are drawn are in a frame.
#[derive(Clone, Copy, Debug)]
pub struct CrowdPlacement {
    /// Lower and upper corner of the box around all, metres.
    pub bounds: [DVec3; 2],
    /// The point on the ground that goes along with them.
    pub ground: DVec3,
}

impl CrowdPlacement {
    /// Whether a camera has who stands there in its image: head and feet, and arms at the box's sides.
    pub fn is_in_view(&self, camera: &Camera) -> bool {
        let [low, high] = self.bounds;
        let size = DVec2::from(camera.size.map(f64::from));
        let seen = |x: f64, y: f64, z: f64| {
            let seen = camera.view.transform_point3(DVec3::new(x, y, z));
            (seen.z > camera.near).then(|| camera.project(seen))
        };
        [low.y, high.y].into_iter().all(|y| {
            let sides = [(TRUNK, 0.0), (-TRUNK, 0.0), (0.0, TRUNK), (0.0, -TRUNK)];
            let corners = [
                (low.x, low.z),
                (low.x, high.z),
                (high.x, low.z),
                (high.x, high.z),
            ];
            let upright = |(x, z)| seen(self.ground.x + x, y, self.ground.z + z);
            let is_inside = |at: f64, side: f64| (0.0..=side).contains(&at);
            sides
                .into_iter()
                .all(|side| upright(side).is_some_and(|at| is_inside(at.y, size.y)))
                && corners
                    .into_iter()
                    .all(|(x, z)| seen(x, y, z).is_some_and(|at| is_inside(at.x, size.x)))
        })
    }
}

/// A box that holds every place: what one camera looks at.
pub fn held(places: &[CrowdPlacement]) -> [DVec3; 2] {
    union(places.iter().map(|place| place.bounds))
}

/// For each place a box, all of one size, that goes along smoothly and holds it. `rate`: places a
/// second.
pub fn followed(places: &[CrowdPlacement], rate: f64) -> Vec<[DVec3; 2]> {
    let ground: Vec<DVec3> = places.iter().map(|place| place.ground).collect();
    let path = smoothed(&ground, SMOOTHING * rate);
    let relative = places
        .iter()
        .zip(&path)
        .map(|(place, at)| place.bounds.map(|corner| corner - *at));
    let all = union(relative);
    path.iter()
        .map(|at| all.map(|corner| corner + *at))
        .collect()
}

fn union(boxes: impl Iterator<Item = [DVec3; 2]>) -> [DVec3; 2] {
    boxes
        .reduce(|[low, high], [min, max]| [low.min(min), high.max(max)])
        .unwrap_or_default()
}

/// A path under a Gaussian of so many entries' deviation. It goes on behind its ends as it came, so
/// that a straight one at an even pace stays as it is.
fn smoothed(path: &[DVec3], deviation: f64) -> Vec<DVec3> {
    let [Some(first), Some(last)] = [path.first(), path.last()] else {
        return vec![];
    };
    let end = path.len() as i64 - 1;
    let at = |index: i64| {
        let inside = |index: i64| path[index.clamp(0, end) as usize];
        if index < 0 {
            2.0 * first - inside(-index)
        } else if index > end {
            2.0 * last - inside(2 * end - index)
        } else {
            inside(index)
        }
    };
    let reach = (REACH * deviation).ceil() as i64;
    let weight = |by: i64| match deviation > 0.0 {
        true => (-0.5 * (by as f64 / deviation).powi(2)).exp(),
        false => 1.0,
    };
    let sum: f64 = (-reach..=reach).map(weight).sum();
    (0..=end)
        .map(|index| {
            let near = (-reach..=reach).map(|by| weight(by) * at(index + by));
            near.sum::<DVec3>() / sum
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(at: DVec3) -> CrowdPlacement {
        CrowdPlacement {
            bounds: [
                at - DVec3::new(0.3, 0.0, 0.2),
                at + DVec3::new(0.3, 1.8, 0.2),
            ],
            ground: at * DVec3::new(1.0, 0.0, 1.0),
        }
    }

    #[test]
    fn ranges_may_be_open() {
        let parsed = |text: &str| FrameRange::parse(text).map(|range| (range.start, range.end));
        assert_eq!(parsed("3..5"), Ok((3, Some(5))));
        assert_eq!(parsed("10.."), Ok((10, None)));
        assert_eq!(parsed("..30"), Ok((0, Some(30))));
        assert_eq!(parsed("all"), Ok((0, None)));
        for wrong in ["5..5", "..0", "x", "3", "-1..4", "1..x", "1...4", ""] {
            assert!(parsed(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_clip_has_as_many_frames_as_fit_into_it() {
        let clip = |frames: usize, rate: f64| Clip {
            name: "steps".into(),
            credit: String::new(),
            rate,
            joint: vec![],
            rotation: vec![],
            translation: vec![[0.0; 3]; frames],
            expression: vec![],
            expression_len: 0,
        };
        let of = |text: &str, clip: &Clip, rate: f64| {
            FrameRange::parse(text).unwrap().of(clip, rate).ok()
        };
        for rate in [29.97, 30.0, 59.94, 60.0, 120.0] {
            assert_eq!(of("all", &clip(1377, rate), rate), Some(0..1377), "{rate}");
        }
        // 2 s: at 0, 1/24, …, 2 s.
        let two_seconds = clip(121, 60.0);
        assert_eq!(of("all", &two_seconds, 24.0), Some(0..49));
        assert_eq!(of("10..", &two_seconds, 24.0), Some(10..49));
        assert_eq!(of("..30", &two_seconds, 24.0), Some(0..30));
        assert_eq!(of("0..50", &two_seconds, 24.0), None);
        assert_eq!(of("49..", &two_seconds, 24.0), None);
        assert_eq!(of("all", &two_seconds, 0.4), Some(0..1));
        assert_eq!(of("all", &clip(1, 60.0), 24.0), Some(0..1), "a still");
    }

    #[test]
    fn a_held_box_has_every_place_in_it() {
        let places = [0.0, 3.0, -1.0].map(|x| place(DVec3::new(x, 0.1, 0.0)));
        let [low, high] = held(&places);
        assert!(low.abs_diff_eq(DVec3::new(-1.3, 0.1, -0.2), 1e-12));
        assert!(high.abs_diff_eq(DVec3::new(3.3, 1.9, 0.2), 1e-12));
    }

    #[test]
    fn a_box_that_follows_keeps_its_size_and_an_even_pace() {
        // A walk of 1.2 m/s that sways by 4 cm, and two hops.
        let at = |frame: u32| {
            let seconds = f64::from(frame) / 60.0;
            let sway = 0.04 * (6.0 * seconds).sin();
            let hop = (0.3 * (4.0 * seconds).sin()).max(0.0);
            place(DVec3::new(1.2 * seconds, hop, sway))
        };
        let places: Vec<CrowdPlacement> = (0..200).map(at).collect();
        let boxes = followed(&places, 60.0);
        let size = boxes[0][1] - boxes[0][0];
        for (own, place) in boxes.iter().zip(&places) {
            assert!((own[1] - own[0]).abs_diff_eq(size, 1e-9));
            assert!(own[0].cmple(place.bounds[0] + 1e-9).all());
            assert!(own[1].cmpge(place.bounds[1] - 1e-9).all());
        }
        for (frame, pair) in boxes.windows(2).enumerate() {
            let step = pair[1][0] - pair[0][0];
            assert!((step.x - 1.2 / 60.0).abs() < 1e-9, "{step}");
            assert!(step.y.abs() < 1e-12, "{step}");
            // At the ends nobody knows how it would have swayed on.
            let kept = if (50..150).contains(&frame) {
                0.25
            } else {
                0.6
            };
            assert!(step.z.abs() < kept * 0.24 / 60.0, "{frame}: {step}");
        }
        assert!(size.x < 0.61, "all of an even pace is followed: {size}");
    }

    #[test]
    fn few_places_are_followed_too() {
        let places = [0.0, 1.0].map(|x| place(DVec3::new(x, 0.0, 0.0)));
        for rate in [0.1, 1.0, 240.0] {
            let boxes = followed(&places, rate);
            assert_eq!(boxes.len(), 2);
            assert!(boxes.iter().flatten().all(|corner| corner.is_finite()));
        }
        assert_eq!(followed(&places[..1], 30.0).len(), 1);
    }
}
