//! Avatars and a clip in; how long a frame of each takes on this machine's GPU out.

use crate::avatar::{Avatar, motion::Player};
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
pub fn frame_ms(avatars: &[&Avatar], player: &Player, size: [u32; 2]) -> Result<(String, Vec<Option<f64>>)> {
    let setting = Setting { options: RendererOptions::new(size), packed_words: false, rows: 1.0, hold: 1 };
    let gpu = Devices::new(Backend::Vulkan, GpuOptions::headless(None)).get(&setting)?;
    let setting = Setting { options: gpu.settled(setting.options), ..setting }.of(Case::Full);
    let mut intervals = vec![Vec::new(); avatars.len()];
    for _ in 0..ROUNDS {
        for (avatar, intervals) in avatars.iter().zip(&mut intervals) {
            match turn(&gpu, avatar, &setting, player) {
                Ok(new) => intervals.extend(new),
                Err(error) if error.is_refusal() => {}
                Err(error) => return Err(error),
            }
        }
    }
    let device = gpu.describe();
    Ok((format!("{}, {}", device.name, device.driver), intervals.into_iter().map(|all| Some(Spread::of(all)?.median)).collect()))
}

fn turn(gpu: &Opened, avatar: &Avatar, setting: &Setting, player: &Player) -> Result<Vec<f64>> {
    let set = Set { avatar, player, size: setting.options.size, cameras: &[], frames: FRAMES, views: VIEWS, hold: setting.hold };
    let scenes = scene::scenes(Case::Full, &set);
    let mut drawer = Drawer::new(gpu, avatar, setting, Case::Full, false)?;
    Ok(run::time(&mut drawer, &scenes, VIEWS, |_| ())?.intervals)
}
