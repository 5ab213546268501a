//! Savings and costs of packing an avatar, step by step. In: an avatar, a quality, and the views to
//! draw. Out: for each step the bytes of the file, of its arrays and of the device's model, and two
//! errors against the f64 reference of the original avatar.
//!
//! The first error is that of the rounding by this step and those before it: the reference draws
//! both avatars. The second is that of what a device draws: the reference draws the packed avatar
//! as a device holds it, which is rounded too ([`reference::render_stored`]). How far the second
//! falls from step to step is the visible cost of packing. Both are over the pixels that the avatar
//! covers, in all views together.

use crate::{
    error::{self, RegionError},
    viewpoint::{self, FOV, PITCH},
};
use effigy_core::{
    avatar::{Avatar, Pose, motion::Player},
    io::{
        file::{self, FormatError},
        pack::{PackQuality, PackStep},
    },
    layout::{pack::ModelSizes, sh},
    reference::{self, Culled},
    scene::{AvatarBounds, Camera, FrameImage, Orbit, Posed},
};
use serde::Serialize;

/// The views to draw.
#[derive(Clone, Copy)]
pub struct Views<'a> {
    /// The clip to take poses from.
    pub player: &'a Player,
    /// Number of images, spread over the clip, each from another side. With none, only sizes are
    /// measured.
    pub images: usize,
    /// Width and height, px.
    pub size: [u32; 2],
}

/// An avatar after a step of packing and those before it.
#[derive(Clone, Debug, Serialize)]
pub struct PackingStep {
    /// Name of the step.
    pub what: &'static str,
    /// Bytes of the file.
    pub file: usize,
    /// Bytes of its tensors before compression: about what its arrays take in memory, except for a
    /// few that are widened there.
    pub raw: usize,
    /// Bytes of the renderers' model, levels included.
    pub device: usize,
    /// PSNR against the original avatar, both drawn exactly, dB. Infinite, and null in JSON, if
    /// every pixel is equal. None without views.
    pub rounded_db: Option<f64>,
    /// PSNR of the avatar as a device holds it against the original drawn exactly, dB.
    pub drawn_db: Option<f64>,
}

/// One view of the original avatar.
struct ReferenceView {
    pose: Pose,
    camera: Camera,
    reference: FrameImage,
}

/// Measures the original avatar, the same compressed without loss, then with where its Gaussians
/// face if `faced` is that, and then each step of a quality. Returns these and the packed avatar.
/// `progress` is called with what is being done, how many images are done, and how many there are.
///
/// # Errors
/// When the avatar breaks a rule of its format.
pub fn measure_steps(
    avatar: &Avatar,
    faced: Option<Avatar>,
    quality: PackQuality,
    views: &Views,
    mut progress: impl FnMut(&str, usize, usize),
) -> Result<(Vec<PackingStep>, Avatar), FormatError> {
    let steps: Vec<PackStep> = quality
        .steps()
        .iter()
        .copied()
        .filter(|step| step.applies_to(avatar))
        .collect();
    let image_count = views.images * (steps.len() + 2 + usize::from(faced.is_some()));
    let mut done = 0;
    let mut references = Vec::with_capacity(views.images);
    for index in 0..views.images {
        progress("drawing the avatar as it is", done, image_count);
        references.push(view(avatar, views, index));
        done += 1;
    }
    progress("drawing it as a device holds it", done, image_count);
    let plain = avatar.to_bytes()?;
    let original = measure("as it is", avatar, &plain, &references)?;
    done += views.images;
    let compressed = avatar.to_packed_bytes()?;
    let mut lines = vec![
        original.clone(),
        PackingStep {
            what: "deflated",
            file: compressed.len(),
            raw: raw_bytes(&compressed)?,
            ..original
        },
    ];
    let mut packed = avatar.clone();
    if let Some(faced) = faced {
        progress("facing", done, image_count);
        packed = faced;
        let bytes = packed.to_packed_bytes()?;
        lines.push(measure("facing", &packed, &bytes, &references)?);
        done += views.images;
    }
    for step in steps {
        progress(step.name(), done, image_count);
        packed = packed.after(step);
        let bytes = packed.to_packed_bytes()?;
        lines.push(measure(step.name(), &packed, &bytes, &references)?);
        done += views.images;
    }
    progress("done", done, image_count);
    Ok((lines, packed))
}

/// Measures an avatar and its file after a step.
fn measure(
    what: &'static str,
    avatar: &Avatar,
    file: &[u8],
    views: &[ReferenceView],
) -> Result<PackingStep, FormatError> {
    Ok(PackingStep {
        what,
        file: file.len(),
        raw: raw_bytes(file)?,
        device: device_bytes(avatar) as usize,
        rounded_db: psnr(avatar, views, reference::render),
        drawn_db: psnr(avatar, views, reference::render_stored),
    })
}

/// Which share of an avatar's Gaussians is not drawn because it faces away, in the mean over the
/// views. None without views.
pub fn facing_away(avatar: &Avatar, views: &Views) -> Option<f64> {
    let of_view = |index: usize| {
        let ViewPoint { posed, camera, .. } = ViewPoint::new(avatar, views, index);
        let gaussians = reference::gaussians_of(avatar, &[&posed], &camera);
        let splats = reference::project::splats(&gaussians, &camera, avatar.filter, 0);
        let away = splats
            .iter()
            .filter(|splat| matches!(splat, Err(Culled::Away)));
        away.count() as f64 / splats.len() as f64
    };
    let sum: f64 = (0..views.images).map(of_view).sum();
    (views.images > 0).then(|| sum / views.images as f64)
}

/// Bytes of an avatar and its levels on a device.
fn device_bytes(avatar: &Avatar) -> u64 {
    let own = ModelSizes::from_avatar(avatar).total() + sh::bytes(avatar);
    let levels = avatar.levels.iter().map(|level| {
        // All else is the avatar's.
        let drawn = avatar.at_level(level);
        let sizes = ModelSizes::from_avatar(&drawn);
        sizes.gaussians + sizes.rows + sh::bytes(&drawn)
    });
    own + levels.sum::<u64>()
}

/// Bytes of a file's tensors before compression.
fn raw_bytes(file: &[u8]) -> Result<usize, FormatError> {
    let tensors = file::tensors_of(file)?;
    Ok(tensors.iter().map(|tensor| tensor.bytes).sum())
}

/// Where a view is seen from.
struct ViewPoint {
    pose: Pose,
    posed: Posed,
    camera: Camera,
}

impl ViewPoint {
    fn new(avatar: &Avatar, views: &Views, index: usize) -> Self {
        let share = (index as f64 + 0.5) / views.images as f64;
        let pose = views.player.pose(share * views.player.clip().duration());
        let posed = Posed::new(avatar, &pose);
        let framing = AvatarBounds::new(avatar).framing(&posed.joints);
        // Consecutive views are from sides that are far apart.
        let yaw = viewpoint::yaw(0.618 * index as f64);
        let camera = Camera::around(
            framing,
            Orbit {
                yaw,
                pitch: PITCH,
                fov: FOV,
            },
            views.size,
        );
        Self {
            pose,
            posed,
            camera,
        }
    }
}

fn view(avatar: &Avatar, views: &Views, index: usize) -> ReferenceView {
    let ViewPoint {
        pose,
        posed,
        camera,
    } = ViewPoint::new(avatar, views, index);
    ReferenceView {
        reference: reference::render(avatar, &posed, &camera),
        pose,
        camera,
    }
}

/// PSNR of an avatar, drawn by `draw`, over all views together, dB. None without views.
fn psnr(
    avatar: &Avatar,
    views: &[ReferenceView],
    draw: fn(&Avatar, &Posed, &Camera) -> FrameImage,
) -> Option<f64> {
    let covered = views.iter().map(|view| {
        let posed = Posed::new(avatar, &view.pose);
        let image = draw(avatar, &posed, &view.camera);
        error::between(&image, &view.reference).covered
    });
    combined_psnr(covered.collect())
}

/// PSNR over the pixels of several regions together, dB. None without pixels.
fn combined_psnr(regions: Vec<RegionError>) -> Option<f64> {
    let pixels: usize = regions.iter().map(|region| region.pixels).sum();
    let squares: f64 = regions
        .iter()
        .map(|region| region.pixels as f64 * 10f64.powf(-region.psnr_db / 10.0))
        .sum();
    (pixels > 0).then(|| -10.0 * (squares / pixels as f64).log10())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_count_by_their_pixels() {
        let region = |pixels, psnr_db| RegionError {
            pixels,
            psnr_db,
            max_error: 0.0,
            within_tolerance: 1.0,
            visible: 0,
        };
        let near =
            |got: Option<f64>, expected: f64| got.is_some_and(|got| (got - expected).abs() < 1e-9);
        assert!(near(
            combined_psnr(vec![region(10, 40.0), region(30, 40.0)]),
            40.0
        ));
        assert!(near(
            combined_psnr(vec![region(10, 40.0), region(10, f64::INFINITY)]),
            40.0 + 10.0 * 2f64.log10()
        ));
        assert_eq!(
            combined_psnr(vec![region(10, f64::INFINITY)]),
            Some(f64::INFINITY)
        );
        assert_eq!(combined_psnr(vec![]), None);
    }

    #[test]
    fn the_demo_shrinks_and_its_image_stays() {
        let avatar = effigy_demo::avatar().expect("inside the program");
        let player = Player::new(
            effigy_demo::clip().expect("inside the program"),
            &avatar.skeleton,
        );
        let views = Views {
            player: &player,
            images: 1,
            size: [120, 150],
        };
        let (lines, packed) =
            measure_steps(&avatar, None, PackQuality::Small, &views, |_, done, all| {
                assert!(done <= all)
            })
            .expect("it can be written");
        let db = |at: usize| {
            (
                lines[at].rounded_db.expect("images"),
                lines[at].drawn_db.expect("images"),
            )
        };
        // It has no spherical harmonics.
        let steps = PackQuality::Small.steps().len() - 1;
        assert_eq!(lines.len(), 2 + steps);
        assert!(db(0).0.is_infinite() && db(2).0.is_infinite(), "{lines:?}");
        assert!(
            lines
                .windows(2)
                .all(|pair| pair[1].file <= pair[0].file && pair[1].device <= pair[0].device),
            "{lines:?}"
        );
        // Rounding that the renderers do anyway does not change the image.
        let high = PackQuality::High.steps().len();
        assert!(
            (db(high).1 - db(0).1).abs() < 1e-2 && db(high).0 > 45.0,
            "{lines:?}"
        );
        assert!(db(lines.len() - 1).0 > 55.0, "{lines:?}");
        assert!(packed == avatar.packed(PackQuality::Small));
        let none = measure_steps(
            &avatar,
            None,
            PackQuality::Lossless,
            &Views { images: 0, ..views },
            |_, _, _| (),
        )
        .expect("it can be written")
        .0;
        assert_eq!((none[0].rounded_db, none[0].drawn_db), (None, None));
    }
}
