//! How like its teacher an avatar is: numbers of its Gaussians, and images by the f64 reference.

use crate::distil::body::UntrainedAvatar;
use crate::distil::samples::InputSamples;
use crate::distil::teacher::{AnchorFeatures, Teacher, TeacherAppearance};
use crate::likeness::{camera_at, neutral};
use effigy_core::avatar::{Avatar, Pose};
use effigy_core::reference::{self, basis::corrective, nodes::displacement, project};
use effigy_core::scene::{AvatarBounds, Posed};
use effigy_math::sampling::evenly_spaced;
use effigy_measure::similarity::similarity;
use glam::{DMat3, DQuat, DVec3};
use half::f16;
use serde::Serialize;

/// Poses of each kind whose numbers are compared.
const POSES: usize = 12;
/// Poses of each kind that are drawn.
const IMAGES: usize = 4;
/// Degrees around the avatar, one an image in turn.
const YAWS: [f64; IMAGES] = [25.0, 115.0, 205.0, 295.0];
/// Radians above the horizon.
const PITCH: f64 = 0.09;
const SIZE: [u32; 2] = [384, 512];
/// Identical images count as this in means, dB.
const MAX_PSNR: f64 = 100.0;

/// Root mean squares of what an avatar's Gaussians differ by from the teacher's, in the canonical
/// pose before skinning, where the networks see the same projected pose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Difference {
    /// Poses that are compared.
    pub poses: usize,
    /// Metres.
    pub position: f64,
    /// Of the ends of the Gaussians' axes, one standard deviation out: metres.
    pub axes: f64,
    /// Of the natural logarithm of the standard deviations.
    pub log_scale: f64,
    /// Of RGB from 0 to 1, without harmonics of degree 1.
    pub color: f64,
    /// 0 to 1.
    pub opacity: f64,
    /// Images of all that the teacher has, harmonics of degree 1 and opacity that follows the pose
    /// included: mean PSNR within the body's box, dB. None where no image shows the body.
    pub psnr_db: Option<f64>,
    /// Mean PSNR against images of the teacher without harmonics of degree 1, dB.
    pub diffuse_db: Option<f64>,
    /// `psnr_db` of the avatar without what it learned.
    pub neutral_db: Option<f64>,
}

/// How like its teacher an avatar is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Likeness {
    /// The share of the variance of training and held-out rows that is left.
    pub unexplained: [f64; 2],
    /// In poses that it learned from.
    pub learned: Difference,
    /// In poses that were held out.
    pub held: Difference,
    /// Share of the joints' weights that four a Gaussian leave out, mean.
    pub skin_lost: f64,
    /// Opacity about its mean over the poses, root mean square.
    pub opacity_lost: f64,
    /// RGB of the harmonics of degree 1, in the direction in which they are largest, root mean
    /// square: what an avatar's file has no place for.
    pub harmonics_lost: f64,
}

/// Compares an avatar with its teacher; `unexplained` stays 0.
pub fn judge(
    teacher: &Teacher,
    features: &AnchorFeatures,
    samples: &InputSamples,
    body: &UntrainedAvatar,
    avatar: &Avatar,
) -> Likeness {
    let judge = Judge {
        teacher,
        features,
        samples,
        body,
        avatar,
        neutral: &neutral(avatar),
        bounds: AvatarBounds::new(avatar),
    };
    let any = evenly_spaced(&samples.learned, 1);
    let harmonics_lost = any.first().map_or(0.0, |&pose| {
        let look = teacher.look(features, 2 * pose);
        let squares = look.harmonics.iter().flatten().map(|c| c * c);
        (squares.sum::<f64>() / (3 * look.harmonics.len()).max(1) as f64).sqrt()
    });
    Likeness {
        unexplained: [0.0; 2],
        learned: judge.difference(&samples.learned),
        held: judge.difference(&samples.held),
        skin_lost: body.skin_lost,
        opacity_lost: body.opacity_lost,
        harmonics_lost,
    }
}

struct Judge<'a, 'c, 'p> {
    teacher: &'a Teacher<'c, 'p>,
    features: &'a AnchorFeatures,
    samples: &'a InputSamples,
    body: &'a UntrainedAvatar,
    avatar: &'a Avatar,
    neutral: &'a Avatar,
    bounds: AvatarBounds,
}

/// Sums of squares.
#[derive(Default)]
struct ErrorSums {
    position: f64,
    axes: f64,
    log_scale: f64,
    color: f64,
    opacity: f64,
    count: f64,
}

impl Judge<'_, '_, '_> {
    /// Of some poses, indices into the samples'.
    fn difference(&self, poses: &[usize]) -> Difference {
        let mut sums = ErrorSums::default();
        let compared = evenly_spaced(poses, POSES);
        for &pose in &compared {
            let look = self.teacher.look(self.features, 2 * pose);
            self.add(&look, &self.samples.poses[pose], &mut sums);
        }
        let mut psnr = Vec::new();
        let mut diffuse = Vec::new();
        let mut neutral = Vec::new();
        for (at, &pose) in evenly_spaced(poses, IMAGES).iter().enumerate() {
            let look = self.teacher.look(self.features, 2 * pose);
            let pose = &self.samples.poses[pose];
            psnr.extend(self.image(&look, pose, YAWS[at % IMAGES], self.avatar));
            neutral.extend(self.image(&look, pose, YAWS[at % IMAGES], self.neutral));
            let look = TeacherAppearance {
                harmonics: vec![],
                ..look
            };
            diffuse.extend(self.image(&look, pose, YAWS[at % IMAGES], self.avatar));
        }
        let root = |sum: f64| (sum / sums.count.max(1.0)).sqrt();
        let mean =
            |all: &[f64]| (!all.is_empty()).then(|| all.iter().sum::<f64>() / all.len() as f64);
        Difference {
            poses: compared.len(),
            position: root(sums.position),
            axes: root(sums.axes / 3.0),
            log_scale: root(sums.log_scale / 3.0),
            color: root(sums.color / 3.0),
            opacity: root(sums.opacity),
            psnr_db: mean(&psnr),
            diffuse_db: mean(&diffuse),
            neutral_db: mean(&neutral),
        }
    }

    /// Adds what all Gaussians differ by in a pose.
    fn add(&self, look: &TeacherAppearance, pose: &Pose, sums: &mut ErrorSums) {
        let avatar = self.avatar;
        let input = avatar.inputs.from_pose(pose);
        let features = reference::mlp::features(avatar, &input);
        let moved = reference::nodes::nodes(avatar, &features);
        let own = &avatar.gaussians;
        for (gaussian, &k) in self.body.order.iter().enumerate() {
            let k = k as usize;
            let e = reference::mlp::of_gaussian(avatar, &features, gaussian);
            let weights = avatar.node_weights(gaussian);
            let position =
                avatar.position(gaussian) + displacement(weights, own.node[gaussian], &moved);
            sums.position += position.distance_squared(look.position[k]);
            let rotation = project::rotation(
                own.rotation[gaussian].map(f16::to_f64),
                corrective(&avatar.rotation_rows, gaussian, e),
            );
            let log_scale = DVec3::from(own.log_scale[gaussian].map(f16::to_f64))
                + DVec3::from(corrective(&avatar.scale_rows, gaussian, e));
            let color = DVec3::from(own.color[gaussian].map(f16::to_f64))
                + DVec3::from(corrective(&avatar.color_rows, gaussian, e));
            let expected = DVec3::from(look.log_scale[k]);
            let truth = project::rotation(look.rotation[k], [0.0; 4]);
            sums.axes += axes_off([rotation, truth], [log_scale, expected]);
            sums.log_scale += log_scale.distance_squared(expected);
            let bounded = |color: DVec3| color.clamp(DVec3::ZERO, DVec3::ONE);
            sums.color += bounded(color).distance_squared(bounded(look.color[k].into()));
            sums.opacity += (f64::from(own.opacity[gaussian]) / 255.0 - look.opacity[k]).powi(2);
            sums.count += 1.0;
        }
    }

    /// PSNR of an avatar's image in a pose, dB.
    fn image(
        &self,
        look: &TeacherAppearance,
        pose: &Pose,
        yaw: f64,
        avatar: &Avatar,
    ) -> Option<f64> {
        let posed = Posed::new(avatar, pose);
        let camera = camera_at(&self.bounds, &posed, yaw, PITCH, SIZE);
        let truth = self.teacher.posed(look, pose, camera.eye());
        let truth = reference::render_gaussians(&truth, &camera, avatar.filter);
        let image = reference::render(avatar, &posed, &camera);
        Some(similarity(&image, &truth)?.psnr_db.min(MAX_PSNR))
    }
}

/// Squared metres that the ends of the axes of two Gaussians are apart, summed over the axes. Those
/// of one index are compared, in either direction.
fn axes_off(rotation: [DQuat; 2], log_scale: [DVec3; 2]) -> f64 {
    let axes =
        |at: usize| DMat3::from_quat(rotation[at]) * DMat3::from_diagonal(log_scale[at].exp());
    let (a, b) = (axes(0), axes(1));
    (0..3)
        .map(|axis| {
            let (a, b) = (a.col(axis), b.col(axis));
            a.distance_squared(b).min(a.distance_squared(-b))
        })
        .sum()
}
