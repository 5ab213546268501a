//! How alike an avatar's images are to its dataset's, drawn by the f64 reference: training frames,
//! held-out frames and clips, with the correctives, without them, and without the projection of
//! poses.

use crate::dataset::{Dataset, Shot};
use effigy_core::avatar::{Avatar, Inputs, Rows};
use effigy_core::reference::{self, project};
use effigy_core::scene::{AvatarBounds, Camera, FrameImage, Orbit, Posed};
use effigy_measure::similarity::{Similarity, similarity};
use glam::{DMat3, DVec3};
use half::f16;
use rayon::prelude::*;
use serde::Serialize;

/// Radians above the horizon from which cameras look if nothing else is asked for.
const PITCH: f64 = 0.09;
/// Identical images count as this in means, dB.
const MAX_PSNR: f64 = 100.0;

/// How much of what it learned an avatar is drawn with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rendition {
    /// Neutral attributes, whatever the pose.
    Neutral,
    /// With everything in the file.
    Learned,
    /// With poses as they are, not projected onto the training poses' components.
    Unprojected,
}

impl Rendition {
    /// In the order of tables.
    pub const ALL: [Self; 3] = [Self::Neutral, Self::Learned, Self::Unprojected];

    /// The name in tables and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Neutral => "no correctives",
            Self::Learned => "learned",
            Self::Unprojected => "learned, no projection",
        }
    }

    /// The avatar to draw for this rendition.
    pub fn apply(self, avatar: &Avatar) -> Avatar {
        let mut avatar = avatar.clone();
        match self {
            Self::Learned => {}
            Self::Unprojected => {
                avatar.inputs = Inputs {
                    pose_space: None,
                    expression_space: None,
                    ..avatar.inputs
                }
            }
            Self::Neutral => {
                avatar.rotation_rows = Rows::default();
                avatar.scale_rows = Rows::default();
                avatar.color_rows = Rows::default();
                avatar.nodes.basis.halves_mut().fill(f16::ZERO);
            }
        }
        avatar
    }
}

/// Which images to draw.
#[derive(Clone, Debug)]
pub struct EvaluationPlan {
    /// Indices into the dataset's frames.
    pub frames: Vec<usize>,
    /// Degrees around the avatar, a camera each.
    pub yaws: Vec<f64>,
    /// Width and height, px.
    pub size: [u32; 2],
}

/// The mean likeness of a group of images.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Score {
    /// The clip that the frames are from.
    pub clip: String,
    /// Whether the frames were held out from the fit.
    pub held: bool,
    /// [`Rendition::name`].
    #[serde(rename = "way")]
    pub rendition: &'static str,
    /// How many images the mean is over.
    pub images: usize,
    /// The mean likeness to the ground truth.
    #[serde(flatten)]
    pub mean: Similarity,
}

/// A camera that has all of a posed avatar in its image. `yaw`: degrees around the avatar.
pub fn camera_at(bounds: &AvatarBounds, posed: &Posed, yaw: f64, size: [u32; 2]) -> Camera {
    camera_at_pitch(bounds, posed, yaw, PITCH, size)
}

/// A camera that has all of a posed avatar in its image. `yaw`: degrees around the avatar; `pitch`:
/// radians above the horizon.
pub fn camera_at_pitch(
    bounds: &AvatarBounds,
    posed: &Posed,
    yaw: f64,
    pitch: f64,
    size: [u32; 2],
) -> Camera {
    let orbit = Orbit {
        yaw: yaw.to_radians(),
        pitch,
        fov: 35f64.to_radians(),
    };
    Camera::around(bounds.framing(&posed.joints), orbit, size)
}

/// The image of the attributes that the dataset has for a frame.
pub fn ground_truth_image(
    dataset: &Dataset,
    frame: usize,
    posed: &Posed,
    camera: &Camera,
) -> FrameImage {
    let avatar = &dataset.avatar;
    let attributes = dataset.frame(frame);
    let vector = |v: [f16; 3]| DVec3::from(v.map(f16::to_f64));
    let gaussian = |k: usize| {
        let skinning = project::skinning(
            &posed.joints,
            avatar.gaussians.joint[k],
            avatar.gaussians.joint_weight[k],
        );
        let rotation = project::rotation(attributes.rotation[k].map(f16::to_f64), [0.0; 4]);
        let position = avatar.position(k) + vector(attributes.offset[k]);
        project::Gaussian {
            mean: skinning.transform_point3(position),
            axes: skinning.matrix3
                * DMat3::from_quat(rotation)
                * DMat3::from_diagonal(vector(attributes.log_scale[k]).exp()),
            color: vector(attributes.color[k]).clamp(DVec3::ZERO, DVec3::ONE),
            opacity: avatar.gaussians.opacity[k],
        }
    };
    let gaussians: Vec<_> = (0..avatar.gaussians.len())
        .into_par_iter()
        .map(gaussian)
        .collect();
    reference::render_gaussians(&gaussians, camera, avatar.filter)
}

/// Scores by clip, by held out or not, and by rendition. `progress` is called with the number of
/// frames done.
pub fn evaluate(
    dataset: &Dataset,
    avatar: &Avatar,
    renditions: &[Rendition],
    plan: &EvaluationPlan,
    progress: &dyn Fn(usize),
) -> Vec<Score> {
    let drawn: Vec<Avatar> = renditions
        .iter()
        .map(|rendition| rendition.apply(avatar))
        .collect();
    let bounds = AvatarBounds::new(&dataset.avatar);
    let mut sums: Vec<Score> = Vec::new();
    for (done, &frame) in plan.frames.iter().enumerate() {
        let pose = &dataset.poses[frame];
        let posed = Posed::new(avatar, pose);
        for &yaw in &plan.yaws {
            let camera = camera_at(&bounds, &posed, yaw, plan.size);
            let truth = ground_truth_image(dataset, frame, &posed, &camera);
            for (rendition, avatar) in renditions.iter().zip(&drawn) {
                let image = reference::render(avatar, &Posed::new(avatar, pose), &camera);
                // Where the truth covers nothing there is nothing to compare.
                if let Some(found) = similarity(&image, &truth) {
                    let shot = &dataset.header.frames[frame];
                    add_to_group(&mut sums, shot, rendition.name(), &found);
                }
            }
        }
        progress(done + 1);
    }
    for score in &mut sums {
        let count = score.images as f64;
        score.mean = Similarity {
            l1: score.mean.l1 / count,
            psnr_db: score.mean.psnr_db / count,
            ssim: score.mean.ssim / count,
        };
    }
    sums
}

/// Adds an image to the sums of its group.
fn add_to_group(sums: &mut Vec<Score>, shot: &Shot, rendition: &'static str, found: &Similarity) {
    let is_own = |score: &Score| {
        score.clip == shot.clip && score.held == shot.held && score.rendition == rendition
    };
    let group = sums.iter().position(is_own).unwrap_or_else(|| {
        sums.push(Score {
            clip: shot.clip.clone(),
            held: shot.held,
            rendition,
            images: 0,
            mean: Similarity::default(),
        });
        sums.len() - 1
    });
    let score = &mut sums[group];
    score.images += 1;
    score.mean.l1 += found.l1;
    score.mean.psnr_db += found.psnr_db.min(MAX_PSNR);
    score.mean.ssim += found.ssim;
}

/// Images of one size in a row, as one image.
///
/// # Panics
/// When their sizes differ.
pub fn side_by_side(images: &[FrameImage]) -> FrameImage {
    let [width, height] = images.first().map_or([0, 0], |image| image.size);
    assert!(
        images.iter().all(|image| image.size == [width, height]),
        "images of different sizes don't fit side by side"
    );
    let mut pixels = Vec::with_capacity(images.len() * (width * height) as usize);
    for y in 0..height {
        for image in images {
            pixels.extend_from_slice(&image.pixels[(y * width) as usize..][..width as usize]);
        }
    }
    FrameImage {
        size: [width * images.len() as u32, height],
        pixels,
    }
}
