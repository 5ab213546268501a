//! How long a frame of each of some avatars takes on this machine's GPU.

use effigy::vulkan::{GpuOptions, RendererOptions};
use effigy_core::avatar::{Avatar, motion::Player};
use effigy_measure::bench::backend::{BenchDevice, Result};
use effigy_measure::bench::report::TimingSummary;
use effigy_measure::bench::run::{self, CaseRenderer};
use effigy_measure::bench::{Backend, BenchCase, RenderSetting, SceneInputs, open, scene};

/// How often each avatar is timed, one after another, so that disturbances by other programs fall
/// on all of them.
const ROUNDS: usize = 3;
/// Frames of a round, each a new pose.
const FRAMES: usize = 12;
/// Views around the avatar.
const VIEWS: usize = 4;

/// Frame times on one device.
pub struct AvatarFrameTimes {
    /// Name and driver.
    pub device: String,
    /// For each avatar the median time of a frame in full motion, ms; `None` if the renderer
    /// refuses it.
    pub median_ms: Vec<Option<f64>>,
}

/// Times frames of avatars in motion. `size`: width and height of the frames, px.
///
/// # Errors
/// When there is no device, or it is lost or hangs.
pub fn frame_times(
    avatars: &[&Avatar],
    player: &Player,
    size: [u32; 2],
) -> Result<AvatarFrameTimes> {
    let setting = RenderSetting {
        options: RendererOptions::new(size),
        rows: 1.0,
        hold: 1,
    };
    let gpu = open(Backend::Vulkan, &GpuOptions::headless(None))?;
    let setting = RenderSetting {
        options: gpu.resolve(setting.options),
        ..setting
    }
    .for_case(BenchCase::Full);
    let mut intervals = vec![Vec::new(); avatars.len()];
    for _ in 0..ROUNDS {
        for (avatar, intervals) in avatars.iter().zip(&mut intervals) {
            match time_round(&gpu, avatar, &setting, player) {
                Ok(new) => intervals.extend(new),
                Err(error) if error.is_refusal() => {}
                Err(error) => return Err(error),
            }
        }
    }
    let device = gpu.describe();
    let median = |intervals: Vec<f64>| Some(TimingSummary::from_samples(intervals)?.median);
    Ok(AvatarFrameTimes {
        device: format!("{}, {}", device.name, device.driver),
        median_ms: intervals.into_iter().map(median).collect(),
    })
}

/// Times of an avatar's frames, ms.
fn time_round(
    gpu: &BenchDevice,
    avatar: &Avatar,
    setting: &RenderSetting,
    player: &Player,
) -> Result<Vec<f64>> {
    let set = SceneInputs {
        avatar,
        player,
        size: setting.options.size,
        cameras: &[],
        frames: FRAMES,
        views: VIEWS,
        hold: setting.hold,
    };
    let scenes = scene::scenes(BenchCase::Full, &set);
    let mut drawer = CaseRenderer::new(gpu, avatar, setting, BenchCase::Full, false)?;
    Ok(run::time(&mut drawer, &scenes, VIEWS, |_| ())?.intervals)
}
