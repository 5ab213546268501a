//! Has the ways to draw timed for the next start, while the window shows the safest.

use crate::{painter::WindowPainter, scene::ViewerScene};
use effigy::vulkan::{
    Error, GpuOptions,
    trials::{START_BUDGET_MS, TrialScene, TuningTask, tune_aside},
    tuning::{Record, Workload},
};
use std::{
    sync::{Arc, Mutex, PoisonError},
    time::{Duration, Instant},
};

/// A reset of the GPU takes every device on it, but each program is told when it next waits. Of two
/// losses no further apart than this the trial is to blame, as far as anyone knows: a GPU that hangs
/// is reset after 2 to 10 s.
const ONE_RESET: Duration = Duration::from_secs(10);

/// How the trials fare.
#[derive(Clone, Copy, Debug)]
enum Progress {
    Running,
    Ended,
    /// Their device was lost or hung, at a time.
    Lost(Instant),
}

/// Trials on a thread and a device of their own: a driver that hangs in a trial takes nothing from
/// the window.
pub struct BackgroundTrials {
    record: Arc<Record>,
    fate: Fate,
}

impl BackgroundTrials {
    /// Starts timing, if there is anything left to time. Not on CPU drivers, where trials would take
    /// the processor from the frames shown; `effigy bench` measures there.
    pub fn start(
        device: &GpuOptions,
        painter: &WindowPainter,
        scene: &ViewerScene,
    ) -> Option<Self> {
        let gpu = painter.gpu();
        let options = painter.full_quality();
        if gpu.probe.is_cpu() || !Workload::is_open(&options) {
            return None;
        }
        let avatar = scene.avatar();
        let workload = Workload::new(avatar, &options);
        let record = Record::of_device(gpu);
        let known = record.tuning(&workload);
        if known.is_some_and(|tuning| tuning.is_done()) {
            return None;
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
        let record = Arc::new(record);
        let own = record.clone();
        let fate = Fate::default();
        let watched = fate.clone();
        let time = move || {
            let task = TuningTask {
                avatar: &avatar,
                options,
                scenes: &scenes,
                budget_ms: START_BUDGET_MS,
            };
            let timed = tune_aside(&device, &own, &task);
            watched.end(timed.as_ref().err(), Instant::now());
            match timed {
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
            return None;
        }
        Some(Self { record, fate })
    }

    /// The program ends, or may be ended without notice: the candidate under trial is not to blame
    /// for that.
    pub fn withdraw(&self) {
        self.record.withdraw();
    }

    /// Whether they may have brought the window's device down, which is lost now. True once: a loss
    /// after that is the window's own.
    pub fn may_have_lost_the_device(&self) -> bool {
        self.fate.excuses(Instant::now())
    }
}

/// How the trials fare, for the window to look at.
#[derive(Clone)]
struct Fate(Arc<Mutex<Progress>>);

impl Default for Fate {
    fn default() -> Self {
        Self(Arc::new(Mutex::new(Progress::Running)))
    }
}

impl Fate {
    /// The trials end, some with an error.
    fn end(&self, error: Option<&Error>, now: Instant) {
        let mut progress = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        // One that was an excuse already is none for a later loss.
        if let Progress::Running = *progress {
            *progress = match error {
                Some(Error::DeviceLost(_) | Error::Timeout { .. }) => Progress::Lost(now),
                _ => Progress::Ended,
            };
        }
    }

    /// Whether they excuse the window's way to draw for a loss of its device. Once.
    fn excuses(&self, now: Instant) -> bool {
        let mut progress = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match std::mem::replace(&mut *progress, Progress::Ended) {
            Progress::Running => true,
            Progress::Lost(at) => now.saturating_duration_since(at) <= ONE_RESET,
            Progress::Ended => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOST: Error = Error::DeviceLost("a test");
    const HUNG: Error = Error::Timeout {
        what: "a test",
        seconds: 1,
    };

    #[test]
    fn one_reset_of_both_devices_is_blamed_on_the_trial_once() {
        for error in [LOST, HUNG] {
            // The trials' loss is noticed first.
            let fate = Fate::default();
            let now = Instant::now();
            fate.end(Some(&error), now);
            assert!(fate.excuses(now + ONE_RESET / 2), "{error}");
            assert!(!fate.excuses(now + ONE_RESET / 2), "{error}: again");

            // The window's is, while the trials still wait.
            let fate = Fate::default();
            assert!(fate.excuses(now), "{error}");
            fate.end(Some(&error), now + Duration::from_secs(1));
            assert!(
                !fate.excuses(now + Duration::from_secs(2)),
                "{error}: again"
            );
        }
    }

    #[test]
    fn a_loss_by_itself_is_the_windows_own() {
        let now = Instant::now();
        let later = now + ONE_RESET + Duration::from_secs(1);
        let fate = Fate::default();
        fate.end(Some(&LOST), now);
        assert!(!fate.excuses(later), "long after the trials' loss");
        let fate = Fate::default();
        fate.end(None, now);
        assert!(!fate.excuses(now), "the trials ended well");
        let fate = Fate::default();
        fate.end(Some(&Error::Overlay("a test".into())), now);
        assert!(!fate.excuses(now), "they ended with a device that lives");
    }
}
