//! What packing an avatar saves and costs, a step at a time. In: an avatar, a quality, and where pictures are taken. Out: for each step
//! the bytes of the file, of its arrays and of the device's model, and two errors against the f64 reference of the avatar as it was.
//!
//! The first error is of what the step and those before it have rounded, and of nothing else: the reference draws both avatars. The
//! second is what someone sees: the reference draws what a device holds of the packed avatar, which rounds too
//! ([`reference::render_stored`]), and is compared with the same picture as the first. How far it falls from that of the avatar as it was
//! is what packing costs. Both are over the pixels that the avatar covers, of all pictures together.

use super::error::{self, Region};
use crate::{
    avatar::{
        Avatar, Pose,
        file::{self, Fault},
        motion::Player,
        pack::Quality,
    },
    frame::{Camera, Extent, Picture, Posed, upright},
    layout::pack::Sizes,
    reference,
};
use serde::Serialize;
use std::f64::consts::TAU;

/// Vertical field of view, radians, and height above the horizon.
const FOV: f64 = 35.0 * TAU / 360.0;
const PITCH: f64 = 0.09;

/// Where pictures are taken.
#[derive(Clone, Copy)]
pub struct Views<'a> {
    pub player: &'a Player,
    /// Pictures, spread over the clip, each from another side. None: only sizes are told.
    pub pictures: usize,
    /// px.
    pub size: [u32; 2],
}

/// An avatar after a step, and those before it.
#[derive(Clone, Debug, Serialize)]
pub struct Line {
    pub what: &'static str,
    /// Bytes of the file.
    pub file: usize,
    /// Bytes of its tensors, none deflated: what its arrays take in memory but for a few that are widened there.
    pub raw: usize,
    /// Bytes of the renderers' model.
    pub device: usize,
    /// Against the avatar as it was, both drawn exactly, dB; infinite, null in JSON, where every pixel is the same. None without pictures.
    pub rounded_db: Option<f64>,
    /// The same of what a device holds.
    pub drawn_db: Option<f64>,
}

/// A picture's scene.
struct Scene {
    pose: Pose,
    camera: Camera,
    truth: Picture,
}

/// The avatar as it was, the same deflated, and then after each step of a quality; the last line's file and avatar are the result.
/// `progress` is told what is done, and how many of how many pictures are.
///
/// # Errors
/// When the avatar breaks a rule of its format.
pub fn steps(
    avatar: &Avatar,
    quality: Quality,
    views: &Views,
    mut progress: impl FnMut(&str, usize, usize),
) -> Result<(Vec<Line>, Avatar), Fault> {
    let all = views.pictures * (quality.steps().len() + 2);
    let mut done = 0;
    let mut tell = |what: &str, more: usize| {
        progress(what, done, all);
        done += more;
    };
    let scenes: Vec<Scene> = (0..views.pictures)
        .map(|number| {
            tell("drawing the avatar as it is", 1);
            scene(avatar, views, number)
        })
        .collect();
    let plain = avatar.to_bytes()?;
    tell("drawing what a device holds of it", views.pictures);
    let [rounded_db, drawn_db] = errors(avatar, &scenes);
    let first =
        Line { what: "as it is", file: plain.len(), raw: raw(&plain)?, device: Sizes::of(avatar).total() as usize, rounded_db, drawn_db };
    let packed = avatar.to_packed_bytes()?;
    let mut lines = vec![first.clone(), Line { what: "deflated", file: packed.len(), raw: raw(&packed)?, ..first }];
    let mut now = avatar.clone();
    for &step in quality.steps() {
        tell(step.name(), views.pictures);
        now = now.after(step);
        let bytes = now.to_packed_bytes()?;
        let [rounded_db, drawn_db] = errors(&now, &scenes);
        let (raw, device) = (raw(&bytes)?, Sizes::of(&now).total() as usize);
        lines.push(Line { what: step.name(), file: bytes.len(), raw, device, rounded_db, drawn_db });
    }
    tell("done", 0);
    Ok((lines, now))
}

/// Bytes of the tensors of a file, none deflated.
fn raw(bytes: &[u8]) -> Result<usize, Fault> {
    Ok(file::tensors_of(bytes)?.iter().map(|tensor| tensor.bytes).sum())
}

fn scene(avatar: &Avatar, views: &Views, number: usize) -> Scene {
    let share = (number as f64 + 0.5) / views.pictures as f64;
    let pose = views.player.pose(share * views.player.clip().duration());
    let posed = Posed::new(avatar, &pose);
    let bounds = upright(Extent::new(avatar).bounds(&posed.joints));
    // Neighbouring pictures are of sides that are far apart.
    let yaw = TAU * (0.05 + 0.618 * number as f64);
    let camera = Camera::around(bounds, yaw, PITCH, FOV, views.size);
    Scene { truth: reference::render(avatar, &posed, &camera), pose, camera }
}

/// Of all pictures together: exactly drawn, and as a device holds it.
fn errors(avatar: &Avatar, scenes: &[Scene]) -> [Option<f64>; 2] {
    let of = |draw: fn(&Avatar, &Posed, &Camera) -> Picture| {
        let regions = scenes.iter().map(|scene| {
            let posed = Posed::new(avatar, &scene.pose);
            error::between(&draw(avatar, &posed, &scene.camera), &scene.truth).covered
        });
        together(regions.collect())
    };
    [of(reference::render), of(reference::render_stored)]
}

/// The PSNR over the pixels of several regions.
fn together(regions: Vec<Region>) -> Option<f64> {
    let pixels: usize = regions.iter().map(|region| region.pixels).sum();
    let squares: f64 = regions.iter().map(|region| region.pixels as f64 * 10f64.powf(-region.psnr_db / 10.0)).sum();
    (pixels > 0).then(|| -10.0 * (squares / pixels as f64).log10())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::demo;

    #[test]
    fn regions_count_by_their_pixels() {
        let region = |pixels, psnr_db| Region { pixels, psnr_db, max_error: 0.0, within_tolerance: 1.0 };
        let near = |got: Option<f64>, expected: f64| got.is_some_and(|got| (got - expected).abs() < 1e-9);
        assert!(near(together(vec![region(10, 40.0), region(30, 40.0)]), 40.0));
        assert!(near(together(vec![region(10, 40.0), region(10, f64::INFINITY)]), 40.0 + 10.0 * 2f64.log10()));
        assert_eq!(together(vec![region(10, f64::INFINITY)]), Some(f64::INFINITY));
        assert_eq!(together(vec![]), None);
    }

    #[test]
    fn the_demo_shrinks_and_what_is_drawn_stays() {
        let avatar = demo::avatar().expect("inside the program");
        let player = Player::new(demo::clip().expect("inside the program"), &avatar.skeleton);
        let views = Views { player: &player, pictures: 1, size: [120, 150] };
        let (lines, packed) = steps(&avatar, Quality::Small, &views, |_, done, all| assert!(done <= all)).expect("it can be written");
        let db = |at: usize| (lines[at].rounded_db.expect("pictures"), lines[at].drawn_db.expect("pictures"));
        assert_eq!(lines.len(), 2 + Quality::Small.steps().len());
        assert!(db(0).0.is_infinite() && db(2).0.is_infinite(), "{lines:?}");
        assert!(lines.windows(2).all(|pair| pair[1].file <= pair[0].file && pair[1].device <= pair[0].device), "{lines:?}");
        // What the renderers round anyway changes nothing that they draw.
        let high = Quality::High.steps().len() + 1;
        assert!((db(high).1 - db(0).1).abs() < 1e-2 && db(high).0 > 45.0, "{lines:?}");
        assert!(db(lines.len() - 1).0 > 55.0, "{lines:?}");
        assert!(packed == avatar.packed(Quality::Small));
        let none = steps(&avatar, Quality::Lossless, &Views { pictures: 0, ..views }, |_, _, _| ()).expect("it can be written").0;
        assert_eq!((none[0].rounded_db, none[0].drawn_db), (None, None));
    }
}
