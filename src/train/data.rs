//! The views of a training: which pictures, in which order, cut out how.

use crate::view::{Shows, TrainingView, ViewPicture};
use effigy_capture::{Capture, CaptureError};
use effigy_core::avatar::{Avatar, Pose};
use effigy_core::random::{Random, hash};
use effigy_core::scene::{Camera, PixelRect};
use glam::{DAffine3, DVec2, DVec3, UVec2};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// How pictures become views.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DataOptions {
    /// Half the width of the band at the mask's edge in which masks are not believed, px: there the
    /// avatar is compared over what is behind the person in the picture itself.
    pub band: u32,
    /// Longest side of a view, px: larger people are looked at in parts.
    pub window: u32,
    /// How much larger than the template a person is in pictures, of the template's size.
    pub margin: f64,
    /// Memory for decoded pictures, MB.
    pub cache_mb: usize,
    /// Frames whose pose differs from the last one's by less are left out: the mean of what the
    /// networks see, radians.
    pub duplicate: f64,
}

/// A picture of the capture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShotIndex {
    /// Index into the capture's cameras.
    pub camera: usize,
    /// Index into its frames.
    pub frame: usize,
}

/// The pictures that are learned from: those of cameras and frames that are not held out.
pub fn training_shots(capture: &Capture) -> Vec<ShotIndex> {
    shots(capture, |camera, frame| !camera && !frame)
}

/// [`training_shots`] without frames whose pose differs from the last one that stays by less than so
/// much: the mean of what an avatar's networks see, radians.
pub fn distinct_shots(capture: &Capture, avatar: &Avatar, least: f64) -> Vec<ShotIndex> {
    let mut last: Option<Vec<f64>> = None;
    let stays: Vec<bool> = capture
        .frames
        .iter()
        .map(|frame| {
            if frame.held {
                return true;
            }
            let own = avatar.inputs.unprojected(&frame.pose);
            let change = last.as_ref().map(|last| {
                let sum: f64 = own.iter().zip(last).map(|(a, b)| (a - b).abs()).sum();
                sum / own.len().max(1) as f64
            });
            let stays = change.is_none_or(|change| change >= least);
            if stays {
                last = Some(own);
            }
            stays
        })
        .collect();
    let mut shots = training_shots(capture);
    shots.retain(|shot| stays[shot.frame]);
    shots
}

/// Pictures by whether their camera and their frame are held out.
pub fn shots(capture: &Capture, takes: impl Fn(bool, bool) -> bool) -> Vec<ShotIndex> {
    let mut all = Vec::new();
    for frame in 0..capture.frames.len() {
        for camera in 0..capture.cameras.len() {
            let held = takes(capture.cameras[camera].held, capture.frames[frame].held);
            if held && capture.has(camera, frame) {
                all.push(ShotIndex { camera, frame });
            }
        }
    }
    all
}

/// A colour for a background.
pub fn random_color(random: &mut Random) -> [u8; 3] {
    [(); 3].map(|()| (255.0 * random.uniform()).round() as u8)
}

/// A frame's pose, evaluated for an avatar.
struct PosedFrame {
    joints: Vec<DAffine3>,
    input: Vec<f64>,
}

/// A decoded picture with what its pixels show.
struct DecodedPicture {
    size: [u32; 2],
    /// RGB and a [`Shows`].
    pixels: Vec<[u8; 4]>,
    edges: Vec<EdgePixel>,
}

/// A pixel of the mask's edge, and what is behind the person there.
struct EdgePixel {
    pixel: u32,
    behind: [u8; 3],
}

/// A view, and which picture it is of.
pub struct LoadedView {
    /// The view.
    pub view: TrainingView,
    /// Its picture.
    pub shot: ShotIndex,
}

/// Pictures that stay in memory.
struct PictureCache {
    /// Which can't be read.
    broken: Vec<bool>,
    pictures: Vec<Option<Arc<DecodedPicture>>>,
    bytes: usize,
}

/// The views of a capture. Which view comes when depends on the seed alone.
pub struct TrainingViews {
    capture: Arc<Capture>,
    options: DataOptions,
    seed: u64,
    /// In the capture's order.
    shots: Vec<ShotIndex>,
    /// Where the template is in each shot's picture, px.
    boxes: Vec<PixelRect>,
    frames: Vec<PosedFrame>,
    size: [u32; 2],
    cache: Mutex<PictureCache>,
}

impl TrainingViews {
    /// The views of some pictures. The template's box in each says what is cut out. `size`: of
    /// every view, px, at most that of every picture; None: what the largest box needs.
    pub fn new(
        capture: &Arc<Capture>,
        avatar: &Avatar,
        shots: Vec<ShotIndex>,
        options: &DataOptions,
        seed: u64,
        size: Option<[u32; 2]>,
    ) -> Self {
        let frames: Vec<PosedFrame> = capture
            .frames
            .iter()
            .map(|frame| PosedFrame {
                joints: avatar.skeleton.matrices(&frame.pose),
                input: avatar.inputs.unprojected(&frame.pose),
            })
            .collect();
        let vertices: Vec<Vec<DVec3>> = capture
            .frames
            .par_iter()
            .map(|frame| template_points(capture, &frame.pose))
            .collect();
        let boxes: Vec<PixelRect> = shots
            .iter()
            .map(|shot| {
                let camera = &capture.cameras[shot.camera].camera;
                box_of(&vertices[shot.frame], camera, options.margin)
            })
            .collect();
        let largest = boxes
            .iter()
            .fold(UVec2::ONE, |all, rect| all.max(rect.max - rect.min));
        // All views of a step have one size.
        let side = |axis: usize| {
            let least = shots
                .iter()
                .map(|shot| capture.cameras[shot.camera].camera.size[axis])
                .min();
            largest[axis]
                .next_multiple_of(8)
                .min(options.window)
                .min(least.unwrap_or(1))
        };
        Self {
            capture: capture.clone(),
            options: options.clone(),
            seed,
            size: size.unwrap_or_else(|| [side(0), side(1)]),
            cache: Mutex::new(PictureCache {
                broken: vec![false; shots.len()],
                pictures: (0..shots.len()).map(|_| None).collect(),
                bytes: 0,
            }),
            shots,
            boxes,
            frames,
        }
    }

    /// Width and height of every view, px.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// A name of the pictures, cameras and frames, which changes with any of them.
    pub fn name(&self) -> String {
        let mut sum = hash(u64::from(self.size[0]) << 32 | u64::from(self.size[1]));
        let mut add = |number: u64| sum = hash(sum ^ number);
        for shot in &self.shots {
            let name = &self.capture.cameras[shot.camera].name;
            name.bytes().for_each(|byte| add(u64::from(byte)));
            add(u64::from(self.capture.frames[shot.frame].number) | 1 << 32);
        }
        for frame in &self.frames {
            frame.input.iter().for_each(|v| add(v.to_bits()));
        }
        format!("{} pictures, {sum:016x}", self.shots.len())
    }

    /// The pictures.
    pub fn shots(&self) -> &[ShotIndex] {
        &self.shots
    }

    /// How many pictures there are.
    pub fn len(&self) -> usize {
        self.shots.len()
    }

    /// Whether it is empty.
    pub fn is_empty(&self) -> bool {
        self.shots.is_empty()
    }

    /// The number of the picture that comes at a place of the training: every one once before any
    /// comes again.
    pub fn shot_at(&self, place: u64) -> usize {
        let count = self.shots.len() as u64;
        let round = place / count;
        shuffled(place % count, count, hash(self.seed ^ hash(round))) as usize
    }

    /// The view that comes at a place of the training, cut out at random, before a random
    /// background. Where its picture can't be read, the next that can stands in for it.
    ///
    /// # Errors
    /// When no picture can be read any more.
    pub fn at(&self, place: u64) -> Result<LoadedView, CaptureError> {
        let mut random = Random::new(self.seed, place);
        let background = random_color(&mut random);
        let share = DVec2::new(random.uniform(), random.uniform());
        self.readable(self.shot_at(place), background, share)
    }

    /// A picture before a background of one's choice, cut out around its middle. Where it can't be
    /// read, the next that can stands in for it.
    ///
    /// # Errors
    /// When no picture can be read any more.
    pub fn steady(&self, shot: usize, background: [u8; 3]) -> Result<LoadedView, CaptureError> {
        self.readable(shot, background, DVec2::splat(0.5))
    }

    /// The first picture from one on that can be read.
    fn readable(
        &self,
        first: usize,
        background: [u8; 3],
        share: DVec2,
    ) -> Result<LoadedView, CaptureError> {
        let mut fault = None;
        for shot in (first..self.shots.len()).chain(0..first) {
            match self.view(shot, background, share) {
                Ok(view) => {
                    return Ok(LoadedView {
                        view,
                        shot: self.shots[shot],
                    });
                }
                Err(error) => {
                    if !self.cache().broken[shot] {
                        tracing::warn!("left out: {error}");
                    }
                    self.cache().broken[shot] = true;
                    fault.get_or_insert(error);
                }
            }
        }
        // There is at least one shot: without any there is no training.
        Err(fault.unwrap_or(CaptureError::NoPicture {
            camera: 0,
            frame: 0,
        }))
    }

    fn view(
        &self,
        at: usize,
        background: [u8; 3],
        share: DVec2,
    ) -> Result<TrainingView, CaptureError> {
        let shot = self.shots[at];
        let picture = self.decoded(at)?;
        let size = UVec2::from(self.size);
        let whole = UVec2::from(picture.size);
        let own = self.boxes[at];
        // Anywhere that holds all of the person, or, of a larger one, only the person.
        let low = own.max.saturating_sub(size).min(own.min);
        let high = own.min.max(own.max.saturating_sub(size));
        let range = (high - low).as_dvec2();
        let corner = (low.as_dvec2() + share * range).round().as_uvec2();
        let corner = corner.min(whole - size);
        let rect = PixelRect {
            min: corner,
            max: corner + size,
        };
        let frame = &self.frames[shot.frame];
        Ok(TrainingView {
            joints: frame.joints.clone(),
            input: frame.input.clone(),
            camera: self.capture.cameras[shot.camera].camera.cropped(rect),
            gain: DVec3::ONE,
            whole: u64::from(whole.x) * u64::from(whole.y),
            picture: Arc::new(picture.cut(rect, background)),
        })
    }

    fn cache(&self) -> MutexGuard<'_, PictureCache> {
        self.cache.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn decoded(&self, at: usize) -> Result<Arc<DecodedPicture>, CaptureError> {
        if let Some(known) = &self.cache().pictures[at] {
            return Ok(known.clone());
        }
        let shot = self.shots[at];
        let picture = self.capture.picture(shot.camera, shot.frame)?;
        let new = Arc::new(DecodedPicture::new(&picture, self.options.band));
        let mut cache = self.cache();
        let bytes = size_of_val(&new.pixels[..]) + size_of_val(&new.edges[..]);
        if cache.pictures[at].is_none() && cache.bytes + bytes <= self.options.cache_mb << 20 {
            cache.bytes += bytes;
            cache.pictures[at] = Some(new.clone());
        }
        Ok(new)
    }
}

/// Some of the template's vertices in a pose.
fn template_points(capture: &Capture, pose: &Pose) -> Vec<DVec3> {
    const MOST: usize = 2000;
    let all = capture.template.posed(pose);
    let step = all.len().div_ceil(MOST).max(1);
    all.into_iter().step_by(step).collect()
}

/// The box around points in an image, larger by a margin on each side; the whole image without
/// any.
fn box_of(points: &[DVec3], camera: &Camera, margin: f64) -> PixelRect {
    let size = DVec2::from(camera.size.map(f64::from));
    let mut low = DVec2::INFINITY;
    let mut high = DVec2::NEG_INFINITY;
    for &point in points {
        let seen = camera.view.transform_point3(point);
        if seen.z >= camera.near {
            let at = camera.project(seen);
            low = low.min(at);
            high = high.max(at);
        }
    }
    let extra = margin * (high - low);
    let min = (low - extra).clamp(DVec2::ZERO, size);
    let max = (high + extra).clamp(DVec2::ZERO, size);
    if !(min.cmplt(max).all()) {
        return PixelRect {
            min: UVec2::ZERO,
            max: UVec2::from(camera.size),
        };
    }
    PixelRect {
        min: min.floor().as_uvec2(),
        max: max.ceil().as_uvec2(),
    }
}

/// The place of a number below `count` in a random order that the seed says: a small cipher of
/// numbers, walked until it gives one below `count`.
fn shuffled(number: u64, count: u64, seed: u64) -> u64 {
    let half = (64 - count.max(2).saturating_sub(1).leading_zeros()).div_ceil(2);
    let mask = (1u64 << half) - 1;
    let mut at = number;
    loop {
        let [mut left, mut right] = [at >> half, at & mask];
        for round in 0..4 {
            let mixed = left ^ (hash(right ^ hash(seed ^ round)) & mask);
            [left, right] = [right, mixed];
        }
        at = left << half | right;
        if at < count {
            return at;
        }
    }
}

impl DecodedPicture {
    /// A picture with a band around the mask's edge. Where nothing is known of what is behind the
    /// person, nothing is known of the band.
    fn new(picture: &effigy_capture::Picture, band: u32) -> Self {
        let near = picture.near_edge(band);
        let behind = if near.contains(&true) {
            picture.behind(band + 1)
        } else {
            None
        };
        let mut edges = Vec::new();
        let pixels = (0..near.len())
            .map(|at| {
                let [r, g, b] = picture.color[at];
                let shows = match &behind {
                    Some(behind) if near[at] => {
                        edges.push(EdgePixel {
                            pixel: at as u32,
                            behind: behind[at],
                        });
                        Shows::Edge
                    }
                    None if near[at] => Shows::Unknown,
                    _ if picture.is_person(at) => Shows::Person,
                    _ => Shows::Background,
                };
                [r, g, b, shows as u8]
            })
            .collect();
        Self {
            size: picture.size,
            pixels,
            edges,
        }
    }

    /// A part of it, with a colour in place of the background. `rect`: inside the picture.
    fn cut(&self, rect: PixelRect, background: [u8; 3]) -> ViewPicture {
        let [r, g, b] = background;
        let whole = self.size[0];
        let size = rect.max - rect.min;
        let mut pixels = Vec::with_capacity((size.x * size.y) as usize);
        for row in rect.min.y..rect.max.y {
            let first = (row * whole + rect.min.x) as usize;
            let own = &self.pixels[first..first + size.x as usize];
            pixels.extend(own.iter().map(|&pixel| {
                if pixel[3] == Shows::Background as u8 {
                    [r, g, b, pixel[3]]
                } else {
                    pixel
                }
            }));
        }
        let mut behind = vec![[r, g, b, 0]; pixels.len()];
        for edge in &self.edges {
            let at = UVec2::new(edge.pixel % whole, edge.pixel / whole);
            if at.cmpge(rect.min).all() && at.cmplt(rect.max).all() {
                let [r, g, b] = edge.behind;
                let at = at - rect.min;
                behind[(at.y * size.x + at.x) as usize] = [r, g, b, 0];
            }
        }
        ViewPicture {
            size: size.into(),
            pixels,
            behind,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_round_has_every_picture_once() {
        for count in [1, 2, 3, 7, 16, 100, 1601] {
            for seed in [1, 2] {
                let mut all: Vec<u64> = (0..count).map(|k| shuffled(k, count, seed)).collect();
                assert!(count < 16 || all.windows(2).any(|pair| pair[1] < pair[0]));
                all.sort_unstable();
                assert_eq!(all, (0..count).collect::<Vec<_>>());
            }
        }
    }

    fn row() -> effigy_capture::Picture {
        effigy_capture::Picture {
            size: [9, 5],
            color: (0..45).map(|at| [at % 9 * 10, 20, 30]).collect(),
            mask: (0..45)
                .map(|at| if at % 9 >= 4 { 255 } else { 0 })
                .collect(),
        }
    }

    #[test]
    fn at_the_edge_of_a_mask_the_picture_has_its_own_background() {
        let rect = PixelRect {
            min: UVec2::new(1, 0),
            max: UVec2::new(7, 1),
        };
        let shown = |band: u32| {
            let cut = DecodedPicture::new(&row(), band).cut(rect, [1, 2, 3]);
            let shows: Vec<Shows> = (0..6).map(|at| cut.shows(at)).collect();
            (cut, shows)
        };
        use Shows::{Background, Edge, Person};
        let (cut, shows) = shown(0);
        assert_eq!(
            shows,
            [Background, Background, Background, Person, Person, Person]
        );
        assert_eq!(cut.pixels[2], [1, 2, 3, 85]);
        assert_eq!(cut.pixels[3], [40, 20, 30, 255]);
        assert!(cut.behind.iter().all(|&pixel| pixel == [1, 2, 3, 0]));
        let (cut, shows) = shown(1);
        assert_eq!(shows, [Background, Background, Edge, Edge, Person, Person]);
        // Two pixels from the mask it is sure to be the background's own.
        assert_eq!(cut.pixels[2], [30, 20, 30, 170]);
        let behind: Vec<u8> = cut.behind.iter().map(|pixel| pixel[0]).collect();
        assert_eq!(behind, [1, 1, 20, 20, 1, 1]);
        let (_, shows) = shown(2);
        assert_eq!(shows, [Background, Edge, Edge, Edge, Edge, Person]);
        // Nothing is seen that is not the person or near it.
        assert!(shown(4).1.contains(&Shows::Unknown));
    }
}
