//! The error over a spread of poses and views: a task and a setting go in; the mean error, the worst
//! view and where it is come out.
//!
//! The reference takes seconds an image, so few frames can be compared with it, and what is wrong in
//! one pose from one side is missed. Here a setting's images are compared with those that the same
//! device draws with nothing skipped, many times as many in the same time;
//! [`measure`](super::measure) compares a few with the reference itself.

use super::{
    case::{BenchScene, BenchTask, PosedInstance},
    frames::{BenchDevice, BenchRenderer, Progress, Result},
    report::{SpreadReport, ViewReport},
};
use crate::{
    coverage::{self, SilhouetteCoverage},
    error::{self, RegionError},
    setting::RenderSetting,
    viewpoint::{FOV, PITCH, yaw_of_view},
};
use effigy_core::{
    avatar::motion::Player,
    frame::{RendererOptions, Skip},
    io::cameras,
    scene::{AvatarBounds, Camera, Framing, Posed},
};

/// Longest side of the images, px. Small ones show the same faults in a fraction of the time.
const SIDE: u32 = 1024;
/// How far the camera is, of the distance at which all of the avatar is in the image. The poses of
/// a clip take turns.
const DISTANCES: [f64; 3] = [1.0, 0.6, 0.3];

/// One image of the spread.
struct SpreadView<'a> {
    clip: &'a Player,
    /// Time in the clip, seconds.
    seconds: f64,
    /// Index among the views of a pose.
    view: usize,
    scene: BenchScene,
}

/// All views, pose by pose. `size`: of the images, px.
fn views<'a>(task: &BenchTask<'a>, size: [u32; 2]) -> Vec<SpreadView<'a>> {
    let bounds = AvatarBounds::new(task.avatar);
    let mut views = Vec::new();
    for clip in task.clips {
        // Of a clip that stands still, no more poses than there are distances.
        let poses = if clip.clip().duration() > 0.0 {
            task.spread
        } else if task.cameras.is_empty() {
            task.spread.min(DISTANCES.len())
        } else {
            task.spread.min(1)
        };
        for pose in 0..poses {
            let seconds = clip.clip().duration() * pose as f64 / (poses.max(2) - 1) as f64;
            let posed = Posed::new(task.avatar, &clip.pose(seconds));
            let framed = bounds.framing(&posed.joints);
            let cameras = cameras_of(task, pose, framed, size).into_iter();
            views.extend(cameras.enumerate().map(|(view, camera)| SpreadView {
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
            }));
        }
    }
    views
}

/// The cameras of a pose. `framed`: the avatar in it.
fn cameras_of(task: &BenchTask, pose: usize, framed: Framing, size: [u32; 2]) -> Vec<Camera> {
    if !task.cameras.is_empty() {
        let scaled = |camera| cameras::scaled(camera, size);
        return task.cameras.iter().map(scaled).collect();
    }
    let middle = framed.middle();
    let distance =
        DISTANCES[pose % DISTANCES.len()] * Camera::framing_distance(framed.bounds, FOV, size);
    let yaw = |view| yaw_of_view(view, task.views);
    (0..task.views)
        .map(|view| Camera {
            near: framed.near,
            ..Camera::orbit(middle, yaw(view), PITCH, distance, FOV, size)
        })
        .collect()
}

/// Draws each view twice on a device, as `setting` says and with nothing skipped, full detail and
/// all rows, and summarises how far the images differ. None if no view shows the avatar.
///
/// # Errors
/// When the device fails.
pub fn measure_spread(
    gpu: &BenchDevice,
    task: &BenchTask,
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
        supersampling: drawn.supersampling,
        ..drawn.exactly()
    };
    let mut renderer = BenchRenderer::new(gpu, &setting.reduce(task.avatar), drawn)?;
    let mut exact_renderer = BenchRenderer::new(gpu, task.avatar, exact)?;
    let views = views(task, size);
    let mut reports = Vec::new();
    for (done, view) in views.iter().enumerate() {
        progress("comparing poses and views", done, views.len());
        renderer.draw(&view.scene)?;
        let image = renderer.image()?;
        exact_renderer.draw(&view.scene)?;
        let exact_image = exact_renderer.image()?;
        let error = error::between(&image, &exact_image).covered;
        if error.pixels > 0 {
            reports.push(view.report(error, coverage::inside_silhouette(&exact_image)));
        }
    }
    Ok(summary(size, reports))
}

/// A size of the same shape whose sides are at most [`SIDE`].
fn reduced(size: [u32; 2]) -> [u32; 2] {
    let longest = size[0].max(size[1]);
    if longest <= SIDE {
        return size;
    }
    size.map(|side| (u64::from(side) * u64::from(SIDE) / u64::from(longest)).max(1) as u32)
}

impl SpreadView<'_> {
    fn report(&self, error: RegionError, silhouette: SilhouetteCoverage) -> ViewReport {
        let eye = self.scene.camera.eye();
        ViewReport {
            clip: self.clip.clip().name.clone(),
            seconds: self.seconds,
            view: self.view,
            eye: eye.to_array(),
            psnr_db: error.psnr_db.is_finite().then_some(error.psnr_db),
            max_error: error.max_error,
            visible: error.visible as u64,
            coverage: silhouette.mean,
            holes: silhouette.holes as u64,
        }
    }
}

fn summary(size: [u32; 2], mut views: Vec<ViewReport>) -> Option<SpreadReport> {
    let decibels = |view: &ViewReport| view.psnr_db.unwrap_or(f64::INFINITY);
    views.sort_by(|a, b| decibels(a).total_cmp(&decibels(b)));
    let worst = views.first()?.clone();
    let most_visible = views.iter().max_by_key(|view| view.visible)?.clone();
    let least_covered = views
        .iter()
        .min_by(|a, b| a.coverage.total_cmp(&b.coverage))
        .cloned();
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
        least_covered,
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
            coverage: 1.0 - 0.01 * visible as f64,
            holes: visible,
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
        assert_eq!(spread.least_covered.map(|view| view.holes), Some(8));
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
        let task = BenchTask {
            avatar: &avatar,
            clips: &clips,
            cameras: &[],
            frames: None,
            views: 2,
            checked: 0,
            flip: false,
            spread: 3,
        };
        let views = views(&task, [100, 120]);
        assert_eq!(views.len(), 6);
        assert_eq!(views[0].seconds, 0.0);
        assert_eq!(views[5].seconds, clips[0].clip().duration());
        let distance = |view: &SpreadView| {
            let eye = view.scene.camera.eye();
            let joints = &view.scene.instances[0].drawn.joints;
            (eye - AvatarBounds::new(&avatar).framing(joints).middle()).length()
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
