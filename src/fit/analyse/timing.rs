//! Avatars and poses in; how long a frame of each takes on this machine's GPU out.

use crate::avatar::motion::{Clip, Player};
use crate::avatar::{Avatar, Pose};
use crate::measure::bench::backend::{Opened, Result};
use crate::measure::bench::report::Spread;
use crate::measure::bench::run::{self, Drawer};
use crate::measure::bench::{Backend, Case, Devices, Set, Setting, scene};
use crate::vulkan::{GpuOptions, RendererOptions};

/// Turns that each avatar has, one after another, so that what else the machine does falls on all of them.
const ROUNDS: usize = 3;
/// Frames of a turn, each a new pose.
const FRAMES: usize = 12;
/// Views around the avatar.
const VIEWS: usize = 4;

/// The device's name, and the median time of a frame in full motion, ms, of each avatar; none where the renderer refuses it.
///
/// # Errors
/// When there is no device, or it is lost or hangs.
pub fn frame_ms(avatars: &[&Avatar], poses: &[Pose], size: [u32; 2]) -> Result<(String, Vec<Option<f64>>)> {
    let setting = Setting { options: RendererOptions::new(size), packed_words: false, rows: 1.0, hold: 1 };
    let gpu = Devices::new(Backend::Vulkan, GpuOptions::headless(None)).get(&setting)?;
    let setting = Setting { options: gpu.settled(setting.options), ..setting }.of(Case::Full);
    let mut intervals = vec![Vec::new(); avatars.len()];
    for _ in 0..ROUNDS {
        for (avatar, intervals) in avatars.iter().zip(&mut intervals) {
            match turn(&gpu, avatar, &setting, poses) {
                Ok(new) => intervals.extend(new),
                Err(error) if error.is_refusal() => {}
                Err(error) => return Err(error),
            }
        }
    }
    let device = gpu.describe();
    Ok((format!("{}, {}", device.name, device.driver), intervals.into_iter().map(|all| Some(Spread::of(all)?.median)).collect()))
}

fn turn(gpu: &Opened, avatar: &Avatar, setting: &Setting, poses: &[Pose]) -> Result<Vec<f64>> {
    let player = Player::new(clip(avatar, poses), &avatar.skeleton);
    let set = Set { avatar, player: &player, size: setting.options.size, cameras: &[], frames: FRAMES, views: VIEWS, hold: setting.hold };
    let scenes = scene::scenes(Case::Full, &set);
    let mut drawer = Drawer::new(gpu, avatar, setting, Case::Full, false)?;
    Ok(run::time(&mut drawer, &scenes, VIEWS, |_| ())?.intervals)
}

/// Poses of an avatar's skeleton, one after another.
fn clip(avatar: &Avatar, poses: &[Pose]) -> Clip {
    Clip {
        name: "poses".into(),
        rotation: poses.iter().flat_map(|pose| pose.rotation.iter().map(|r| r.as_vec3().to_array())).collect(),
        translation: poses.iter().map(|pose| pose.translation.as_vec3().to_array()).collect(),
        expression: poses.iter().flat_map(|pose| pose.expression.iter().map(|&e| e as f32)).collect(),
        expression_len: poses.first().map_or(0, |pose| pose.expression.len()),
        rate: 30.0,
        ..Clip::still(&avatar.skeleton)
    }
}
