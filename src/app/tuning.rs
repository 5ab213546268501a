//! Has the ways to draw timed for the next start, while the window shows the safest.

use crate::{painter::WindowPainter, scene::ViewerScene};
use effigy::vulkan::{
    GpuOptions,
    trials::{START_BUDGET_MS, TrialScene, TuningTask, tune_aside},
    tuning::{Record, Workload},
};

/// Starts timing on a thread and a device of their own, if there is anything left to time: a driver
/// that hangs in a trial takes nothing from the window. Not on CPU drivers, where trials would take
/// the processor from the frames shown; `effigy bench` measures there.
pub fn start(device: &GpuOptions, painter: &WindowPainter, scene: &ViewerScene) {
    let gpu = painter.gpu();
    let options = painter.full_quality();
    if gpu.probe.is_cpu() || !Workload::is_open(&options) {
        return;
    }
    let avatar = scene.avatar();
    let workload = Workload::new(avatar, &options);
    let known = Record::of_device(gpu).tuning(&workload);
    if known.is_some_and(|tuning| tuning.is_done()) {
        return;
    }
    let scenes = match scene.player() {
        Some(player) => TrialScene::of_clip(avatar, player, options.size),
        None => TrialScene::around(avatar, &[scene.posed().clone()], options.size),
    };
    let device = GpuOptions {
        device: Some(gpu.probe.name.clone()),
        ..device.clone()
    };
    let avatar = avatar.clone();
    let time = move || {
        let task = TuningTask {
            avatar: &avatar,
            options,
            scenes: &scenes,
            budget_ms: START_BUDGET_MS,
        };
        match tune_aside(&device, &task) {
            Ok(tuning) => {
                tracing::info!(
                    "the next start draws with {}: {}",
                    tuning.best,
                    tuning.reason()
                );
            }
            Err(error) => tracing::warn!("not all ways to draw could be timed: {error}"),
        }
    };
    let thread = std::thread::Builder::new().name("trials".into());
    if let Err(error) = thread.spawn(time) {
        tracing::warn!("the ways to draw are not timed: {error}");
    }
}
