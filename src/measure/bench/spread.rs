//! The error over a spread of poses and views: an avatar, clips, cameras and a setting go in; the
//! mean error, the worst view and where it is come out.
//!
//! The reference takes seconds an image, so few frames can be compared with it, and what is wrong in
//! one pose from one side is missed. Here a setting's images are compared with those that the same
//! device draws with nothing skipped, many times as many in the same time; [`check`](super::check)
//! compares a few with the reference itself.

use super::{
    backend::{BenchDevice, BenchRenderer, Result},
    report::{SpreadReport, ViewReport},
    run::Progress,
    scene::{BenchScene, FOV, PITCH, PosedInstance},
};
use crate::{
    error::{self, RegionError},
    setting::RenderSetting,
};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    frame::{RendererOptions, Skip, preset::Preset},
    io::cameras,
    scene::{AvatarBounds, Camera, Posed, upright},
};
use std::f64::consts::TAU;

/// Longest side of the images, px. Small ones show the same faults in a fraction of the time.
const SIDE: u32 = 1024;
/// How far the camera is, of the distance at which all of the avatar is in the image. The poses of
/// a clip take turns.
const DISTANCES: [f64; 3] = [1.0, 0.6, 0.3];

/// What a spread is made of.
#[derive(Clone, Copy)]
pub struct SpreadInputs<'a> {
    /// The avatar, with all its rows.
    pub avatar: &'a Avatar,
    /// The clips that move it.
    pub clips: &'a [Player],
    /// Cameras, in place of those around the avatar; may be empty.
    pub cameras: &'a [Camera],
    /// Poses of each clip, from its start to its end.
    pub poses: usize,
    /// Views around the avatar of each pose.
    pub views: usize,
}

/// One image of the spread.
struct View<'a> {
    clip: &'a Player,
    /// Time in the clip, seconds.
    seconds: f64,
    /// Index among the views of a pose.
    view: usize,
    scene: BenchScene,
}

impl<'a> SpreadInputs<'a> {
    /// All views, pose by pose. `size`: of the images, px.
    fn views(&self, size: [u32; 2]) -> impl Iterator<Item = View<'a>> {
        let inputs = *self;
        let bounds = AvatarBounds::new(inputs.avatar);
        let poses = inputs
            .clips
            .iter()
            .flat_map(move |clip| (0..inputs.poses_of(clip)).map(move |pose| (clip, pose)));
        poses.flat_map(move |(clip, pose)| {
            let last = inputs.poses_of(clip).max(2) - 1;
            let seconds = clip.clip().duration() * pose as f64 / last as f64;
            let posed = Posed::new(inputs.avatar, &clip.pose(seconds));
            let framed = upright(bounds.bounds(&posed.joints));
            let cameras: Vec<Camera> = if inputs.cameras.is_empty() {
                let distance =
                    DISTANCES[pose % DISTANCES.len()] * Camera::framing_distance(framed, FOV, size);
                let middle = (framed[0] + framed[1]) / 2.0;
                let yaw = |view: usize| TAU * (0.05 + view as f64 / inputs.views as f64);
                (0..inputs.views)
                    .map(|view| Camera::orbit(middle, yaw(view), PITCH, distance, FOV, size))
                    .collect()
            } else {
                let scaled = |camera| cameras::scaled(camera, size);
                inputs.cameras.iter().map(scaled).collect()
            };
            cameras
                .into_iter()
                .enumerate()
                .map(move |(view, camera)| View {
                    clip,
                    seconds,
                    view,
                    scene: BenchScene {
                        instances: vec![PosedInstance {
                            drawn: posed.clone(),
                            reference: posed.clone(),
                        }],
                        camera,
                    },
                })
        })
    }

    /// A clip that stands still needs no more than a pose a distance.
    fn poses_of(&self, clip: &Player) -> usize {
        match (clip.clip().duration() > 0.0, self.cameras.is_empty()) {
            (true, _) => self.poses,
            (false, true) => self.poses.min(DISTANCES.len()),
            (false, false) => self.poses.min(1),
        }
    }

    fn len(&self) -> usize {
        let views = if self.cameras.is_empty() {
            self.views
        } else {
            self.cameras.len()
        };
        let poses: usize = self.clips.iter().map(|clip| self.poses_of(clip)).sum();
        poses * views
    }
}

/// Compares a setting with nothing skipped, full detail, 32-bit keys and all rows. None where the
/// avatar is in no view.
///
/// # Errors
/// When the device fails.
pub fn measure_spread(
    gpu: &BenchDevice,
    inputs: &SpreadInputs,
    setting: &RenderSetting,
    progress: Progress,
) -> Result<Option<SpreadReport>> {
    let size = reduced(setting.options.size);
    let drawn = RendererOptions {
        size,
        ..setting.options
    };
    let exact = RendererOptions {
        skip: Skip::empty(),
        ..Preset::Exact.apply(drawn)
    };
    let mut renderer = BenchRenderer::new(gpu, &setting.reduce(inputs.avatar), drawn)?;
    let mut exact_renderer = BenchRenderer::new(gpu, inputs.avatar, exact)?;
    let mut views = Vec::new();
    for (done, view) in inputs.views(size).enumerate() {
        progress("comparing poses and views", done, inputs.len());
        renderer.draw(&view.scene)?;
        let image = renderer.image()?;
        exact_renderer.draw(&view.scene)?;
        let error = error::between(&image, &exact_renderer.image()?).covered;
        if error.pixels > 0 {
            views.push(view.report(error));
        }
    }
    Ok(summary(size, views))
}

/// A size of the same shape whose sides are at most [`SIDE`].
fn reduced(size: [u32; 2]) -> [u32; 2] {
    let longest = size[0].max(size[1]);
    if longest <= SIDE {
        return size;
    }
    size.map(|side| (u64::from(side) * u64::from(SIDE) / u64::from(longest)).max(1) as u32)
}

impl View<'_> {
    fn report(&self, error: RegionError) -> ViewReport {
        let eye = self.scene.camera.eye();
        ViewReport {
            clip: self.clip.clip().name.clone(),
            seconds: self.seconds,
            view: self.view,
            eye: eye.to_array(),
            psnr_db: error.psnr_db.is_finite().then_some(error.psnr_db),
            max_error: error.max_error,
            visible: error.visible as u64,
        }
    }
}

fn summary(size: [u32; 2], mut views: Vec<ViewReport>) -> Option<SpreadReport> {
    let decibels = |view: &ViewReport| view.psnr_db.unwrap_or(f64::INFINITY);
    views.sort_by(|a, b| decibels(a).total_cmp(&decibels(b)));
    let worst = views.first()?.clone();
    let most_visible = views.iter().max_by_key(|view| view.visible)?.clone();
    let squares = views.iter().map(|view| 10f64.powf(-0.1 * decibels(view)));
    let mean_db = -10.0 * (squares.sum::<f64>() / views.len() as f64).log10();
    Some(SpreadReport {
        views: views.len(),
        size,
        mean_db: mean_db.is_finite().then_some(mean_db),
        median_db: views[views.len() / 2].psnr_db,
        max_error: views.iter().map(|view| view.max_error).fold(0.0, f64::max),
        worst,
        most_visible,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(seconds: f64, psnr_db: Option<f64>, visible: u64) -> ViewReport {
        ViewReport {
            clip: "walk".into(),
            seconds,
            view: 0,
            eye: [0.0; 3],
            psnr_db,
            max_error: 0.01 * visible as f64,
            visible,
        }
    }

    #[test]
    fn the_worst_view_is_found_by_its_error_and_by_its_pixels() {
        let views = vec![
            view(0.0, None, 0),
            view(1.0, Some(40.0), 3),
            view(2.0, Some(50.0), 8),
        ];
        let spread = summary([8, 8], views).expect("there are views");
        assert_eq!(spread.worst.seconds, 1.0);
        assert_eq!(spread.most_visible.seconds, 2.0);
        assert_eq!(spread.median_db, Some(50.0));
        assert_eq!(spread.max_error, 0.08);
        // (10⁻⁴ + 10⁻⁵ + 0) / 3.
        let mean = spread.mean_db.expect("there is an error");
        assert!((mean - 44.357).abs() < 1e-3, "{mean}");
        assert_eq!(summary([8, 8], Vec::new()), None);
    }

    #[test]
    fn views_are_spread_over_clips_distances_and_sides() {
        let avatar = effigy_demo::avatar().expect("inside the program");
        let clip = effigy_demo::clip().expect("inside the program");
        let clips = [Player::new(clip, &avatar.skeleton)];
        let inputs = SpreadInputs {
            avatar: &avatar,
            clips: &clips,
            cameras: &[],
            poses: 3,
            views: 2,
        };
        let views: Vec<View> = inputs.views([100, 120]).collect();
        assert_eq!(views.len(), inputs.len());
        assert_eq!(views[0].seconds, 0.0);
        assert_eq!(views[5].seconds, clips[0].clip().duration());
        let distance = |view: &View| {
            let eye = view.scene.camera.eye();
            let joints = &view.scene.instances[0].drawn.joints;
            let [min, max] = upright(AvatarBounds::new(&avatar).bounds(joints));
            (eye - (min + max) / 2.0).length()
        };
        assert!(distance(&views[4]) < 0.5 * distance(&views[0]));
        assert_ne!(views[0].scene.camera, views[1].scene.camera);
    }

    #[test]
    fn images_are_reduced_in_their_shape() {
        assert_eq!(reduced([640, 480]), [640, 480]);
        assert_eq!(reduced([2048, 4096]), [512, 1024]);
        assert_eq!(reduced([8192, 1]), [1024, 1]);
    }
}
