//! Has a GPU asked whether it draws faster with quads or tiles, while the window shows the method
//! of its class. The next start draws by the answer.

use crate::{painter::WindowPainter, scene::ViewerScene};
use effigy::vulkan::{
    Error, GpuOptions,
    question::{Aside, Question, QuestionScene},
    sort, trial,
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
enum TrialProgress {
    Running,
    Ended,
    /// Their device was lost or hung, at a time.
    Lost(Instant),
}

/// Trials of sorts and methods on a thread and a device of their own: a driver that hangs in a
/// trial takes nothing from the window.
pub struct BackgroundTrials {
    fate: Fate,
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
        let fate = Fate::default();
        let watched = fate.clone();
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
        Some(Self { fate })
    }

    /// The program ends, or may be ended without notice: what is under trial is not to blame for
    /// that.
    pub fn withdraw(&self) {
        trial::withdraw();
    }

    /// Whether they may have brought the window's device down, which is lost now. True once: a loss
    /// after that is the window's own.
    pub fn may_have_lost_the_device(&self) -> bool {
        self.fate.excuses(Instant::now())
    }
}

/// How the trials fare, for the window to look at.
#[derive(Clone)]
struct Fate(Arc<Mutex<TrialProgress>>);

impl Default for Fate {
    fn default() -> Self {
        Self(Arc::new(Mutex::new(TrialProgress::Running)))
    }
}

impl Fate {
    /// The trials end, some with an error.
    fn end(&self, error: Option<&Error>, now: Instant) {
        let mut progress = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        // One that was an excuse already is none for a later loss.
        if let TrialProgress::Running = *progress {
            *progress = match error {
                Some(Error::DeviceLost(_) | Error::Timeout { .. }) => TrialProgress::Lost(now),
                _ => TrialProgress::Ended,
            };
        }
    }

    /// Whether they excuse the window's way to draw for a loss of its device. Once.
    fn excuses(&self, now: Instant) -> bool {
        let mut progress = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match std::mem::replace(&mut *progress, TrialProgress::Ended) {
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
