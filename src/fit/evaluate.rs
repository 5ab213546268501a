//! An avatar and a dataset in; how alike their pictures are out, drawn by the f64 reference: training frames, held-out frames and
//! clips, with the correctives, without them, and without the projection of poses.

use super::dataset::Dataset;
use crate::avatar::{Avatar, Inputs, Rows};
use crate::frame::{Camera, Extent, Picture, Posed, upright};
use crate::measure::similarity::{Similarity, similarity};
use crate::reference::{self, splats};
use glam::{DMat3, DVec3};
use half::f16;
use rayon::prelude::*;
use serde::Serialize;

/// How the avatar is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Way {
    /// Neutral attributes, whatever the pose.
    Neutral,
    /// As the file says.
    Learned,
    /// With poses as they are, not projected onto the training poses' components.
    Unprojected,
}

impl Way {
    pub const ALL: [Self; 3] = [Self::Neutral, Self::Learned, Self::Unprojected];

    pub fn name(self) -> &'static str {
        ["no correctives", "learned", "learned, no projection"][self as usize]
    }

    /// The avatar that is drawn this way.
    pub fn avatar(self, avatar: &Avatar) -> Avatar {
        let mut avatar = avatar.clone();
        match self {
            Self::Learned => {}
            Self::Unprojected => avatar.inputs = Inputs { pose_space: None, expression_space: None, ..avatar.inputs },
            Self::Neutral => {
                (avatar.rotation_rows, avatar.scale_rows, avatar.color_rows) = (Rows::default(), Rows::default(), Rows::default());
                avatar.nodes.basis.halves_mut().fill(f16::ZERO);
            }
        }
        avatar
    }
}

/// What to draw.
#[derive(Clone, Debug)]
pub struct Plan {
    pub frames: Vec<usize>,
    /// Degrees around the avatar, a camera each.
    pub yaws: Vec<f64>,
    /// Of the longer side, px.
    pub size: [u32; 2],
}

/// Means over pictures.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Score {
    pub clip: String,
    pub held: bool,
    pub way: &'static str,
    pub pictures: usize,
    #[serde(flatten)]
    pub mean: Similarity,
}

/// The camera at a yaw (degrees) that has all of a posed avatar in its picture.
pub fn camera(extent: &Extent, posed: &Posed, yaw: f64, size: [u32; 2]) -> Camera {
    camera_at(extent, posed, yaw, 0.09, size)
}

/// The same at a pitch too, radians above the horizon.
pub fn camera_at(extent: &Extent, posed: &Posed, yaw: f64, pitch: f64, size: [u32; 2]) -> Camera {
    Camera::around(upright(extent.bounds(&posed.joints)), yaw.to_radians(), pitch, 35f64.to_radians(), size)
}

/// The picture of a frame's own attributes.
pub fn truth(dataset: &Dataset, frame: usize, posed: &Posed, camera: &Camera) -> Picture {
    let (avatar, own) = (&dataset.avatar, dataset.frame(frame));
    let gaussian = |k: usize| {
        let g = splats::skinning(&posed.joints, avatar.gaussians.joint[k], avatar.gaussians.joint_weight[k]);
        let vector = |v: [f16; 3]| DVec3::from(v.map(f16::to_f64));
        let q = splats::rotation(own.rotation[k].map(f16::to_f64), [0.0; 4]);
        splats::Gaussian {
            mean: g.transform_point3(avatar.position(k) + vector(own.offset[k])),
            axes: g.matrix3 * DMat3::from_quat(q) * DMat3::from_diagonal(vector(own.log_scale[k]).exp()),
            color: vector(own.color[k]).clamp(DVec3::ZERO, DVec3::ONE),
            opacity: avatar.gaussians.opacity[k],
        }
    };
    let gaussians: Vec<_> = (0..avatar.gaussians.len()).into_par_iter().map(gaussian).collect();
    reference::render_gaussians(&gaussians, camera)
}

/// Pictures a group of frames is judged by, for each way.
pub fn scores(dataset: &Dataset, avatar: &Avatar, ways: &[Way], plan: &Plan, hear: &dyn Fn(usize)) -> Vec<Score> {
    let drawn: Vec<Avatar> = ways.iter().map(|way| way.avatar(avatar)).collect();
    let extent = Extent::new(&dataset.avatar);
    let mut groups: Vec<Score> = Vec::new();
    for (done, &frame) in plan.frames.iter().enumerate() {
        let (pose, shot) = (&dataset.poses[frame], &dataset.header.frames[frame]);
        let posed = Posed::new(avatar, pose);
        for &yaw in &plan.yaws {
            let camera = camera(&extent, &posed, yaw, plan.size);
            let truth = truth(dataset, frame, &posed, &camera);
            for (way, avatar) in ways.iter().zip(&drawn) {
                let picture = reference::render(avatar, &Posed::new(avatar, pose), &camera);
                let Some(found) = similarity(&picture, &truth) else { continue };
                let same = |score: &Score| score.clip == shot.clip && score.held == shot.held && score.way == way.name();
                let score = match groups.iter().position(same) {
                    Some(at) => &mut groups[at],
                    None => {
                        let mean = Similarity::default();
                        groups.push(Score { clip: shot.clip.clone(), held: shot.held, way: way.name(), pictures: 0, mean });
                        groups.last_mut().expect("one was pushed")
                    }
                };
                score.pictures += 1;
                score.mean.l1 += found.l1;
                score.mean.psnr_db += found.psnr_db.min(100.0);
                score.mean.ssim += found.ssim;
            }
        }
        hear(done + 1);
    }
    for score in &mut groups {
        let count = score.pictures as f64;
        score.mean = Similarity { l1: score.mean.l1 / count, psnr_db: score.mean.psnr_db / count, ssim: score.mean.ssim / count };
    }
    groups
}

/// At most `count` of some frames, evenly spaced.
pub fn some(frames: &[usize], count: usize) -> Vec<usize> {
    let take = count.min(frames.len());
    (0..take).map(|k| frames[(2 * k + 1) * frames.len() / (2 * take)]).collect()
}
