//! Has a GPU asked whether it draws faster with quads or tiles, while the window shows the method
//! of its class. The next start draws by the answer.

use crate::{painter::WindowPainter, scene::ViewerScene};
use effigy_render::vulkan::{
    Error, GpuOptions,
    question::{Aside, Question, QuestionScene},
    sort, trial,
};
use std::{
    sync::{Arc, Mutex, PoisonError},
    time::{Duration, Instant},
};

/// A reset of the GPU takes every device on it, but each program is told when it next waits. Of two
/// losses no further apart than this the trial is to blame, as far as anyone knows: a GPU that
/// hangs is reset after 2 to 10 s.
const ONE_RESET: Duration = Duration::from_secs(10);

/// The progress of the trials.
#[derive(Clone, Copy, Debug)]
enum TrialProgress {
    Running,
    Ended,
    /// Their device was lost or hung, at a time.
    Lost(Instant),
}

/// Trials of sorts and methods on a thread and a device of their own: a driver that hangs in a
/// trial takes nothing from the window.
pub struct BackgroundTrials {
    progress: SharedProgress,
}

impl BackgroundTrials {
    /// Starts, if there is anything left to find out. Not on CPU drivers, where trials would take
    /// the processor from the frames shown.
    pub fn start(
        device: &GpuOptions,
        painter: &WindowPainter,
        scene: &ViewerScene,
    ) -> Option<Self> {
        let gpu = painter.gpu();
        let options = painter.full_quality();
        let is_open = Question::is_open(gpu, &options) || !sort::choice::is_tested(gpu);
        if gpu.probe.is_cpu() || !is_open {
            return None;
        }
        let avatar = scene.avatar().clone();
        let scenes = match scene.player() {
            Some(player) => QuestionScene::of_clip(&avatar, player, options.size),
            None => QuestionScene::around(&avatar, &[scene.posed().clone()], options.size),
        };
        let device = Aside::of(gpu, device);
        let progress = SharedProgress::default();
        let watched = progress.clone();
        let ask = move || {
            let question = Question {
                avatar: &avatar,
                options,
                scenes: &scenes,
            };
            let answer = device.open().and_then(|gpu| question.ask(&gpu));
            watched.end(answer.as_ref().err(), Instant::now());
            match answer {
                Ok(choice) => {
                    let method = choice.method.name();
                    tracing::info!("the next start draws with {method}: {}", choice.reason());
                }
                Err(error) => tracing::warn!("quads and tiles could not be compared: {error}"),
            }
        };
        let thread = std::thread::Builder::new().name("trials".into());
        if let Err(error) = thread.spawn(ask) {
            tracing::warn!("quads and tiles are not compared: {error}");
            return None;
        }
        Some(Self { progress })
    }

    /// The program ends, or may be ended without notice: the variant under trial is not to blame
    /// for that.
    pub fn withdraw(&self) {
        trial::withdraw();
    }

    /// Their progress, for another thread.
    pub fn watch(&self) -> SharedProgress {
        self.progress.clone()
    }

    /// Whether the trials may have caused the loss of the window's device. True at most once: later
    /// losses are the window's own.
    pub fn may_have_lost_the_device(&self) -> bool {
        self.progress.excuses(Instant::now())
    }
}

/// The progress of the trials, which the window watches.
#[derive(Clone)]
pub struct SharedProgress(Arc<Mutex<TrialProgress>>);

impl Default for SharedProgress {
    fn default() -> Self {
        Self(Arc::new(Mutex::new(TrialProgress::Running)))
    }
}

impl SharedProgress {
    /// The trials end, some with an error.
    fn end(&self, error: Option<&Error>, now: Instant) {
        let mut own = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        // An outcome excuses at most one lost device.
        if let TrialProgress::Running = *own {
            *own = match error {
                Some(Error::DeviceLost(_) | Error::Timeout { .. }) => TrialProgress::Lost(now),
                _ => TrialProgress::Ended,
            };
        }
    }

    /// Whether the trials still run.
    pub fn is_running(&self) -> bool {
        let own = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        matches!(*own, TrialProgress::Running)
    }

    /// Whether the trials, and not the window's method, may be to blame for a lost device. True at
    /// most once.
    fn excuses(&self, now: Instant) -> bool {
        let mut own = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match std::mem::replace(&mut *own, TrialProgress::Ended) {
            TrialProgress::Running => true,
            TrialProgress::Lost(at) => now.saturating_duration_since(at) <= ONE_RESET,
            TrialProgress::Ended => false,
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
            let progress = SharedProgress::default();
            let now = Instant::now();
            progress.end(Some(&error), now);
            assert!(progress.excuses(now + ONE_RESET / 2), "{error}");
            assert!(!progress.excuses(now + ONE_RESET / 2), "{error}: again");

            // The window's is, while the trials still wait.
            let progress = SharedProgress::default();
            assert!(progress.excuses(now), "{error}");
            progress.end(Some(&error), now + Duration::from_secs(1));
            assert!(
                !progress.excuses(now + Duration::from_secs(2)),
                "{error}: again"
            );
        }
    }

    #[test]
    fn a_loss_by_itself_is_the_windows_own() {
        let now = Instant::now();
        let later = now + ONE_RESET + Duration::from_secs(1);
        let progress = SharedProgress::default();
        progress.end(Some(&LOST), now);
        assert!(!progress.excuses(later), "long after the trials' loss");
        let progress = SharedProgress::default();
        progress.end(None, now);
        assert!(!progress.excuses(now), "the trials ended well");
        let progress = SharedProgress::default();
        progress.end(Some(&Error::Overlay("a test".into())), now);
        assert!(
            !progress.excuses(now),
            "they ended with a device that lives"
        );
    }
}
